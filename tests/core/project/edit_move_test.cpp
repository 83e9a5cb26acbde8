#include "core/ffd/levels/frames_follow.h"
#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <limits>
#include <numeric>

namespace pbffd {

using test::after;
using test::contains;
using test::difference;
using test::levelError;
using test::pointOf;
using test::projectWith;
using test::refusal;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
}

class EditMoveTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void moveShiftsPosedCentresAndNothingElse() {
    const Project before = projectWith();
    Move edit{{std::nullopt, {3, 7}}, {Vec3(0.1, 0.2, 0.3)}, Follow::none, {}};
    const Project moved = after(before, edit);
    for (const PointId id : {3, 7}) {
      QVERIFY(pointOf(moved, id).pose.center == Vec3(pointOf(before, id).pose.center + Vec3(0.1, 0.2, 0.3)));
      QVERIFY(pointOf(moved, id).pose.axes == pointOf(before, id).pose.axes);
      QVERIFY(pointOf(moved, id).rest == pointOf(before, id).rest);
    }
    QVERIFY(pointOf(moved, 4) == pointOf(before, 4));
    QVERIFY(moved.controls.levels[0] == before.controls.levels[0]);
    QVERIFY(moved.controls.levels[1] == before.controls.levels[1]);
    QVERIFY(levelError(moved) < 1e-13);
  }

  void oneVectorAPointMovesEachByItsOwn() {
    const Project before = projectWith();
    const Move edit{{3, {1, 2}}, {Vec3(1, 0, 0), Vec3(0, 2, 0)}, Follow::none, {}};
    const Project moved = after(before, edit);
    QVERIFY(pointOf(moved, 1).pose.center == Vec3(pointOf(before, 1).pose.center + Vec3(1, 0, 0)));
    QVERIFY(pointOf(moved, 2).pose.center == Vec3(pointOf(before, 2).pose.center + Vec3(0, 2, 0)));
    QVERIFY(
        contains(refusal(before, Move{{3, {1, 2, 3}}, edit.by, Follow::none, {}}), "2 vectors for 3 points"));
  }

  void weightsShareOutTheShift() {
    const Project before = projectWith();
    Move edit{{3, {1, 2, 3}}, {Vec3(1, 0, 0)}, Follow::none, {}};
    edit.spread.weights = {1.0, 0.25, 0.0};
    const Project moved = after(before, edit);
    QVERIFY(pointOf(moved, 2).pose.center == Vec3(pointOf(before, 2).pose.center + Vec3(0.25, 0, 0)));
    QVERIFY(pointOf(moved, 3).pose == pointOf(before, 3).pose);
    edit.spread.weights = {1.0};
    QVERIFY(contains(refusal(before, edit), "1 weights for 3 points"));
    edit.spread.weights = {1.0, infinity, 0.0};
    QVERIFY(contains(refusal(before, edit), "not finite"));
  }

  void framesFollowWhatMoved() {
    const Project before = projectWith();
    const Level& finest = before.controls.finest();
    Move edit;
    std::vector<Index> places(finest.size());
    std::iota(places.begin(), places.end(), 0);
    const Mat3 turn = Eigen::AngleAxisd(0.5, Vec3::UnitZ()).toRotationMatrix();
    for (const ControlPoint& point : finest) {
      edit.where.points.push_back(point.id);
      edit.by.push_back((turn - Mat3::Identity()) * point.pose.center);
    }
    const std::vector<Mat3> expected = followingRotations(finest, places, edit.by);
    const Project moved = after(before, edit);
    for (Index i = 0; i < finest.size(); ++i) {
      QVERIFY((moved.controls.finest()[i].pose.axes - expected[i] * finest[i].pose.axes).norm() < 1e-15);
      QVERIFY((expected[i] - turn).norm() < 0.02);
    }
    edit.follow = Follow::none;
    QVERIFY(after(before, edit).controls.finest()[0].pose.axes == finest[0].pose.axes);
  }

  void coarseMoveCarriesFinerLevelsAndLeavesCoarserOnes() {
    const Project before = projectWith();
    const PointId id = before.controls.levels[1][0].id;
    const Project moved = after(before, Move{{2, {id}}, {Vec3(0.2, 0, 0)}, Follow::frames, {}});
    QVERIFY(moved.controls.levels[0] == before.controls.levels[0]);
    QVERIFY(!(moved.controls.levels[2] == before.controls.levels[2]));
    QVERIFY(levelError(moved) < 1e-13);
  }

  void wholeLevelWithTheMasterCarriesEverythingExactly_data() {
    QTest::addColumn<int>("level");
    QTest::newRow("coarsest") << 1;
    QTest::newRow("middle") << 2;
    QTest::newRow("finest") << 3;
  }

  void wholeLevelWithTheMasterCarriesEverythingExactly() {
    QFETCH(int, level);
    Project before = projectWith();
    before = after(before, Move{{3, {1, 5}}, {Vec3(0.1, -0.2, 0.1)}, Follow::none, {}});
    Transform edit;
    edit.where.level = level;
    for (const ControlPoint& point : before.controls.levels[level - 1]) {
      edit.where.points.push_back(point.id);
    }
    edit.pivot = Vec3(0.3, 0.1, -0.2);
    edit.scale = Vec3(1.2, 0.8, 1.1);
    edit.rotationAxis = Vec3(1, 2, 3);
    edit.degrees = 40.0;
    edit.spread.master = true;
    const Project moved = after(before, edit);
    const Mat3 linear = Eigen::AngleAxisd(40.0 * M_PI / 180.0, Vec3(1, 2, 3).normalized()).toRotationMatrix() *
                        edit.scale.asDiagonal();
    const AffineMap map = makeMap(linear, *edit.pivot - linear * *edit.pivot);
    for (std::size_t l = level - 1; l < 3; ++l) {
      for (Index i = 0; i < before.controls.levels[l].size(); ++i) {
        const Frame expected = pbffd::moved(before.controls.levels[l][i].pose, map);
        QVERIFY(difference(moved.controls.levels[l][i].pose, expected) < 1e-12);
      }
    }
    for (int l = 0; l < level - 1; ++l) {
      for (Index i = 0; i < before.controls.levels[l].size(); ++i) {
        QVERIFY(moved.controls.levels[l][i].pose == before.controls.levels[l][i].pose);
      }
    }
    QVERIFY(levelError(moved) < 1e-12);
  }

  void masterGoesAlongWithAMove() {
    const Project before = projectWith();
    Move edit{{3, {1, 2}}, {Vec3(1, 2, 3)}, Follow::none, {}};
    edit.spread.master = true;
    QVERIFY(after(before, edit).controls.master.pose.center ==
            Vec3(before.controls.master.pose.center + Vec3(1, 2, 3)));
    edit.by = {Vec3(1, 0, 0), Vec3(3, 0, 0)};
    QVERIFY(after(before, edit).controls.master.pose.center ==
            Vec3(before.controls.master.pose.center + Vec3(2, 0, 0)));
  }

  void lockedPointsAreLeftOut() {
    Project before = projectWith();
    before = after(before, Lock{{3, {2}}, true});
    const EditResult result = test::resultOf(before, Move{{3, {1, 2}}, {Vec3(1, 0, 0)}, Follow::none, {}});
    const Project& moved = result.project;
    QCOMPARE(result.remarks, std::vector<std::string>{"1 of 2 points is locked and stayed in place."});
    QVERIFY(pointOf(moved, 2).pose == pointOf(before, 2).pose);
    QVERIFY(!(pointOf(moved, 1).pose == pointOf(before, 1).pose));
    QVERIFY(contains(refusal(before, Move{{3, {2}}, {Vec3(1, 0, 0)}, Follow::none, {}}), "point 2 is locked"));
    QVERIFY(contains(refusal(before, SetPose{3, 2, pointOf(before, 2).rest}), "locked"));
    // A coarser level carries them.
    std::vector<PointId> all;
    for (const ControlPoint& point : before.controls.levels[0]) {
      all.push_back(point.id);
    }
    const Project carried = after(before, Move{{1, all}, {Vec3(1, 0, 0)}, Follow::none, {}});
    QVERIFY(!(pointOf(carried, 2).pose == pointOf(before, 2).pose));
  }

  void setPoseIsWhatWasAskedToTheBit() {
    const Project before = projectWith();
    const Frame pose{Vec3(0.1, 0.7, 1.0 / 3.0), (Mat3() << 1, 0.1, 0, 0.2, 1, 0, 0, 0.3, 0.7).finished()};
    const Project posed = after(before, SetPose{std::nullopt, 9, pose});
    QVERIFY(pointOf(posed, 9).pose == pose);
    QVERIFY(levelError(posed) < 1e-13);
  }

  void posesThatCannotBeInvertedAreRefused() {
    const Project before = projectWith();
    QVERIFY(contains(refusal(before, SetPose{3, 1, {Vec3::Zero(), Mat3::Zero()}}), "singular"));
    QVERIFY(
        contains(refusal(before, SetPose{3, 1, {Vec3::Zero(), Mat3(Vec3(1, 1, 0).asDiagonal())}}), "singular"));
    QVERIFY(contains(refusal(before, SetPose{3, 1, {Vec3(0, NAN, 0), Mat3::Identity()}}), "not finite"));
    QVERIFY(contains(refusal(before, SetPose{3, 1, {Vec3::Zero(), Mat3::Constant(infinity)}}), "not finite"));
  }

  void wrongSelectionsAreRefused() {
    const Project before = projectWith();
    const std::vector<Vec3> by{Vec3(1, 0, 0)};
    const auto move = [&](std::optional<int> level, std::vector<PointId> points) {
      return refusal(before, Move{{level, std::move(points)}, by, Follow::none, {}});
    };
    QCOMPARE(move(2, {999}), std::string("there is no point 999 on level 2"));
    QCOMPARE(move(2, {1}), std::string("point 1 is on level 3, not on level 2"));
    QVERIFY(contains(move(4, {1}), "there is no level 4"));
    QVERIFY(contains(move(0, {1}), "there is no level 0"));
    QVERIFY(contains(move(3, {}), "names no points"));
    QVERIFY(contains(move(3, {1, 1}), "point 1 twice"));
    QVERIFY(contains(refusal(before, Move{{3, {1}}, {Vec3(NAN, 0, 0)}, Follow::none, {}}), "not finite"));
    QVERIFY(contains(refusal(before, Move{{3, {1}}, {Vec3(1e308, 1e308, 0), Vec3(1, 1, 1)}, Follow::none, {}}),
                     "2 vectors"));
  }

  void movesOutOfAllBoundsAreRefused() {
    Project before = projectWith();
    const Move far{{1, {before.controls.levels[0][0].id}}, {Vec3(1.5e308, 0, 0)}, Follow::none, {}};
    before = after(before, Move{{3, {1}}, {Vec3(1, 0, 0)}, Follow::none, {}});
    try {
      const Project once = after(before, far);
      QVERIFY(contains(refusal(once, far), "out of all bounds"));
    } catch (const InvalidInput& error) {
      QVERIFY(contains(error.what(), "out of all bounds") || contains(error.what(), "flatten"));
    }
  }

  void groupIsDoneWholeOrNotAtAll() {
    const Project before = projectWith();
    Group group{"Two", {Move{{3, {1}}, {Vec3(1, 0, 0)}, Follow::none, {}}, Rename{3, 2, "Neck"}}};
    const Project both = after(before, group);
    QVERIFY(!(pointOf(both, 1).pose == pointOf(before, 1).pose));
    QCOMPARE(pointOf(both, 2).name, std::string("Neck"));
    group.edits.push_back(Remove{{3, {999}}});
    QVERIFY(contains(refusal(before, group), "its edit 3 (remove, at /2): there is no point 999"));
    QVERIFY(contains(refusal(before, Group{"None", {}}), "no edits"));
  }

  void listOfEditsNamesTheOneThatFails() {
    const Project before = projectWith();
    EditWorkspace workspace;
    const std::vector<Edit> edits{Reset{}, Rename{3, 2, "Neck"},
                                  Move{{2, {999}}, {Vec3(1, 0, 0)}, Follow::none, {}}};
    try {
      applyAll(before, edits, workspace);
      QFAIL("no error");
    } catch (const InvalidInput& error) {
      QCOMPARE(std::string(error.what()),
               std::string("edit 3 (move, at /2): there is no point 999 on level 2"));
    }
  }

  void cancelledEditsThrow() {
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    EditWorkspace workspace;
    QVERIFY_EXCEPTION_THROWN(apply(projectWith(), Reset{}, workspace, progress), Cancelled);
  }
};

const test::Registration<EditMoveTest> registration;

}  // namespace pbffd

#include "edit_move_test.moc"
