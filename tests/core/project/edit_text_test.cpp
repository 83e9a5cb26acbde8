#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class EditTextTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void textsSayWhatAndHowMuch() {
    Project project = test::after(test::projectWith(), Rename{3, 4, "Neck"});
    const auto says = [&](const Edit& edit, const char* text) {
      const std::string description = describe(project, edit);
      QVERIFY2(description == text, description.c_str());
    };
    const Vec3 by(0, 0.35, -0.0);
    says(Move{{3, {4}}, {by}, Follow::frames, {}}, "Move Neck by 0, 0.35, 0");
    says(Move{{std::nullopt, {4}}, {by}, Follow::frames, {}}, "Move Neck by 0, 0.35, 0");
    says(Move{{3, {5}}, {by}, Follow::frames, {}}, "Move point 5 by 0, 0.35, 0");
    says(Move{{3, {4, 5, 6}}, {by}, Follow::frames, {}}, "Move 3 points by 0, 0.35, 0");
    says(Move{{3, {4, 5}}, {by, by}, Follow::frames, {}}, "Move 2 points");
    says(Move{{3, {4}}, {Vec3(-0.1, 1234.5, -2e-7)}, Follow::frames, {}}, "Move Neck by −0.1, 1,230, −2e−07");
    says(Remove{{3, std::vector<PointId>(1000, 5)}}, "Remove 1,000 points");
    Transform turn;
    turn.where = {3, {4, 5}};
    turn.degrees = 26;
    says(turn, "Rotate 2 points 26° about Z");
    turn.rotationAxis = Vec3(0, -2, 0);
    says(turn, "Rotate 2 points 26° about −Y");
    turn.rotationAxis = Vec3(3, 4, 0);
    says(turn, "Rotate 2 points 26° about 0.6, 0.8, 0");
    turn.scale = Vec3::Constant(1.2);
    says(turn, "Scale 2 points to 120 %, rotate 26° about 0.6, 0.8, 0");
    turn.degrees = 0;
    says(turn, "Scale 2 points to 120 %");
    turn.scale = Vec3(1, 2, 1);
    says(turn, "Scale 2 points to 100 %, 200 %, 100 %");
    says(SetPose{3, 4, {}}, "Set pose of Neck");
    says(SetRegion{3, 4, {}}, "Edit region of Neck");
    says(Add{}, "Add point 71");
    says(Remove{{3, {1, 2, 3}}}, "Remove 3 points");
    says(Enable{{3, {1, 2}}, false}, "Disable 2 points");
    says(Enable{{3, {4}}, true}, "Enable Neck");
    says(Lock{{3, {4}}, true}, "Lock Neck");
    says(Strength{{3, {4}}, 2.5}, "Set strength of Neck to 2.5");
    says(SetReach{{3, {4}}, Reach::all}, "Let Neck reach all of the region");
    says(Refine{{3, {4}}, 2}, "Refine Neck to 2 points");
    says(Refine{{3, {4, 5}}, 3}, "Refine 2 points to 6 points");
    says(Rename{3, 5, "Nose"}, "Rename point 5 to Nose");
    says(SetLevels{4}, "Build 4 levels");
    says(SetLevels{4, true}, "Add a coarser level");
    says(SetLevels{2, true}, "Remove the coarsest level");
    says(SetMaster{0.2, MasterMode::constant}, "Set master to 0.2");
    says(SetKernel{{Kernel::wendland, 3}}, "Change kernel to Wendland");
    says(Reset{}, "Reset all points");
    says(Reset{PointSelection{3, {1, 2}}, true}, "Move 2 points back to rest");
    says(Reset{PointSelection{3, {4}}, false}, "Move Neck back to rest");
    says(Place{}, "Place 200 points on 3 levels");
    says(Group{"Raise the arm", {}}, "Raise the arm");
  }

  void textsOfImpossibleEditsAreStillTexts() {
    const Project project = test::projectWith();
    QCOMPARE(describe(project, Move{{9, {999}}, {Vec3(1, 0, 0)}, Follow::none, {}}),
             std::string("Move point 999 by 1, 0, 0"));
  }
};

const test::Registration<EditTextTest> registration;

}  // namespace pbffd

#include "edit_text_test.moc"
