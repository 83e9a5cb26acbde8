#include "core/project/shape.h"
#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

using test::after;
using test::contains;
using test::levelError;
using test::pointOf;
using test::projectWith;
using test::refusal;

/// Back to rest: everything, or some points.
class EditResetTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void resetPutsEveryPoseBackToRest() {
    Project project = projectWith();
    const Project rest = project;
    project =
        after(project, Move{{1, {project.controls.levels[0][1].id}}, {Vec3(0.3, 0, 0)}, Follow::none, {}});
    project = after(project, Move{{3, {4}}, {Vec3(0, 0.2, 0)}, Follow::none, {}});
    Move all{{3, {5}}, {Vec3(0, 0.2, 0)}, Follow::none, {}};
    all.spread.master = true;
    project = after(project, all);
    project = after(project, Reset{});
    QVERIFY(project.controls == rest.controls);
  }

  void resetLeavesLockedPointsWhereTheyAre() {
    Project project = projectWith();
    project = after(project, Move{{3, {4}}, {Vec3(0, 0.2, 0)}, Follow::none, {}});
    project = after(project, Lock{{3, {4}}, true});
    const Frame pose = pointOf(project, 4).pose;
    project = after(project, Move{{3, {5}}, {Vec3(0, 0.2, 0)}, Follow::none, {}});
    EditWorkspace workspace;
    const EditResult result = apply(project, Reset{}, workspace);
    QCOMPARE(result.remarks.size(), std::size_t{1});
    QVERIFY(contains(result.remarks[0], "1 locked point stayed"));
    project = result.project;
    QVERIFY(pointOf(project, 4).pose == pose);
    QVERIFY(pointOf(project, 5).pose == pointOf(project, 5).rest);
    QVERIFY(levelError(project) < 1e-13);
  }

  void pointsGoBackToRestWithTheMasterWhereAsked() {
    const Project rest = projectWith();
    for (int level = 1; level <= 3; ++level) {
      Move all{{level, {}}, {Vec3(0, 0.2, 0)}, Follow::none, {}};
      for (const ControlPoint& point : rest.controls.levels[level - 1]) {
        all.where.points.push_back(point.id);
      }
      all.spread.master = true;
      const Project moved = after(rest, all);
      const Project back = after(moved, Reset{all.where, true});
      QVERIFY(back.controls.master.pose == rest.controls.master.rest);
      QVERIFY(back.controls.levels[level - 1] == rest.controls.levels[level - 1]);
      QVERIFY(levelError(back) < 1e-13);
      QVERIFY((shapeOf(back) - shapeOf(rest)).cwiseAbs().maxCoeff() < 1e-12);
      // Without it what it holds stays away, and other points stay as they are.
      const Project one = after(moved, Reset{PointSelection{level, {all.where.points[0]}}, false});
      QVERIFY(one.controls.master.pose == moved.controls.master.pose);
      QVERIFY(pointOf(one, all.where.points[0]).pose == pointOf(rest, all.where.points[0]).rest);
      QVERIFY(pointOf(one, all.where.points[1]).pose == pointOf(moved, all.where.points[1]).pose);
    }
  }

  void lockedPointsDoNotGoBackToRest() {
    Project project = after(projectWith(), Move{{3, {4, 5}}, {Vec3(0, 0.2, 0)}, Follow::none, {}});
    project = after(project, Lock{{3, {4}}, true});
    EditWorkspace workspace;
    const EditResult result = apply(project, Reset{PointSelection{3, {4, 5}}, false}, workspace);
    QCOMPARE(result.remarks, std::vector<std::string>{"1 of 2 points is locked and stayed in place."});
    QVERIFY(pointOf(result.project, 4).pose == pointOf(project, 4).pose);
    QVERIFY(pointOf(result.project, 5).pose == pointOf(project, 5).rest);
    QVERIFY(contains(refusal(project, Reset{PointSelection{3, {4}}, false}), "point 4 is locked"));
  }

 private:
  static Points shapeOf(const Project& project) {
    EditWorkspace workspace;
    return deformedShape(project, workspace.weights).positions;
  }
};

const test::Registration<EditResetTest> registration;

}  // namespace pbffd

#include "edit_reset_test.moc"
