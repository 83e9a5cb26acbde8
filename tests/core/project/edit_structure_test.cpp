#include "core/project/shape.h"
#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <algorithm>
#include <cstring>
#include <set>

namespace pbffd {

using test::after;
using test::contains;
using test::difference;
using test::levelError;
using test::pointOf;
using test::projectWith;
using test::refusal;

class EditStructureTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void setRegionKeepsTheTransform() {
    Project project = projectWith();
    const Frame rest{Vec3(0.1, 0.2, 0.3), Mat3(Vec3(0.5, 0.6, 0.7).asDiagonal())};
    // At rest it stays at rest, to the bit.
    QVERIFY(pointOf(after(project, SetRegion{3, 1, rest}), 1).pose == rest);
    project = turned(project);
    const AffineMap map = pointOf(project, 1).map();
    const Project changed = after(project, SetRegion{3, 1, rest});
    QVERIFY(pointOf(changed, 1).rest == rest);
    QVERIFY(difference(pointOf(changed, 1).map(), map) < 1e-13);
    QVERIFY(pointOf(changed, 1).binding.at == rest.center);
    QVERIFY(levelError(changed) < 1e-12);
  }

  void regionsThatCannotBeUsedAreRefused() {
    const Project project = projectWith();
    const auto refused = [&](const Frame& rest) { return refusal(project, SetRegion{3, 1, rest}); };
    QVERIFY(contains(refused({Vec3(NAN, 0, 0), Mat3::Identity()}), "not finite"));
    QVERIFY(contains(refused({Vec3::Zero(), Mat3(Vec3(1, 0, 1).asDiagonal())}), "no length"));
    Mat3 skew = Mat3::Identity();
    skew(0, 1) = 1e-8;
    QVERIFY(contains(refused({Vec3::Zero(), skew}), "right angles"));
    skew(0, 1) = 1e-10;
    QVERIFY(refused({Vec3::Zero(), skew}).empty());
    QVERIFY(contains(refusal(after(project, Lock{{3, {1}}, true}), SetRegion{3, 1, {}}), "locked"));
  }

  void influenceEditsKeepEveryTransform() {
    const Project project = turned(projectWith());
    const std::vector<Edit> edits{SetKernel{{Kernel::gaussian, 2.5}},
                                  SetMaster{0.5, MasterMode::constant},
                                  SetReach{{3, {1, 2}}, Reach::all},
                                  Strength{{3, {1}}, 2.0},
                                  Enable{{3, {2}}, false},
                                  Lock{{3, {1}}, true},
                                  Rename{3, 1, "Neck"}};
    for (const Edit& edit : edits) {
      const Project changed = after(project, edit);
      for (std::size_t l = 0; l < 3; ++l) {
        for (Index i = 0; i < project.controls.levels[l].size(); ++i) {
          QVERIFY(changed.controls.levels[l][i].pose == project.controls.levels[l][i].pose);
        }
      }
    }
    QCOMPARE(pointOf(after(project, edits[3]), 1).strength, 2.0);
    for (const double extreme : {1e308, 5e-324}) {
      QVERIFY(contains(refusal(project, Strength{{3, {1}}, extreme}), "is not between 1e-100 and 1e+100"));
    }
    QVERIFY(!pointOf(after(project, edits[4]), 2).enabled);
    QVERIFY(pointOf(after(project, edits[2]), 2).reach == Reach::all);
    QCOMPARE(pointOf(after(project, edits[6]), 1).name, std::string("Neck"));
  }

  void valuesOutOfRangeAreRefused() {
    const Project project = projectWith();
    QVERIFY(contains(refusal(project, Strength{{3, {1}}, 0.0}), "not above 0"));
    QVERIFY(contains(refusal(project, Strength{{3, {1}}, NAN}), "not finite"));
    QVERIFY(contains(refusal(project, SetMaster{-0.1, MasterMode::constant}), "0 or more"));
    QVERIFY(contains(refusal(project, SetMaster{INFINITY, MasterMode::constant}), "not finite"));
    QVERIFY(contains(refusal(project, SetKernel{{Kernel::gaussian, 0.0}}), "above 0"));
  }

  void addedPointTakesTheBlendedTransform() {
    Project project = projectWith();
    const Mat3 linear = Eigen::AngleAxisd(0.6, Vec3::UnitY()).toRotationMatrix() * 1.2;
    project = allMoved(project, linear);
    EditWorkspace workspace;
    const Points before = deformedShape(project, workspace.weights).positions;
    Add edit;
    edit.rest = {Vec3(0.5, 0.2, 0.1), 0.6 * Mat3::Identity()};
    const Project added = after(project, edit);
    const ControlPoint& point = pointOf(added, project.nextId);
    QCOMPARE(added.nextId, project.nextId + 1);
    QVERIFY(point.kind == PointKind::manual);
    QVERIFY(difference(point.map(), makeMap(linear, Vec3::Zero())) < 1e-12);
    // The deformation is affine there: the surface does not change at all.
    const Points now = deformedShape(added, workspace.weights).positions;
    QVERIFY((now - before).cwiseAbs().maxCoeff() < 1e-12);
    QVERIFY(levelError(added) < 1e-12);
  }

  void addedPointOfAnUndeformedMeshIsAtRest() {
    const Project project = projectWith();
    for (int level = 1; level <= 3; ++level) {
      Add edit;
      edit.level = level;
      edit.rest = {Vec3(0.5, 0.2, 0.1), 0.6 * Mat3::Identity()};
      const Project added = after(project, edit);
      QVERIFY(pointOf(added, project.nextId).pose == edit.rest);
      QCOMPARE(added.controls.levels[level - 1].size(), project.controls.levels[level - 1].size() + 1);
    }
  }

  void posedAddFindsTheRestPlace() {
    Project project = projectWith();
    Transform bend;
    bend.where = {1, {project.controls.levels[0][0].id, project.controls.levels[0][1].id}};
    bend.degrees = 20;
    project = after(project, bend);
    EditWorkspace workspace;
    const Vec3 target = deformedShape(project, workspace.weights).positions.row(17).transpose();
    Add edit;
    edit.rest = {target, 0.3 * Mat3::Identity()};
    edit.posed = true;
    const Project added = after(project, edit);
    const ControlPoint& point = pointOf(added, project.nextId);
    QVERIFY((point.pose.center - target).norm() < 1e-11);
    QVERIFY((point.rest.center - project.mesh->positions().row(17).transpose()).norm() < 1e-9);
    QVERIFY((point.rest.axes - edit.rest.axes).norm() == 0.0);
  }

  void addWithoutAxesMakesAUsualSphere() {
    const Project project = projectWith();
    Add edit;
    edit.rest.center = Vec3(0.3, 0.1, 0.2);
    edit.defaultAxes = true;
    double nearest = 1e9;
    for (const ControlPoint& point : project.controls.finest()) {
      nearest = std::min(nearest, (point.rest.center - edit.rest.center).norm());
    }
    const Frame rest = pointOf(after(project, edit), project.nextId).rest;
    QVERIFY((rest.axes - 2.0 * nearest * Mat3::Identity()).norm() < 1e-12);
  }

  void identifiersOfAddedPointsAreFree() {
    const Project project = projectWith();
    Add edit;
    edit.rest.center = Vec3(0.3, 0.1, 0.2);
    edit.id = 5000;
    const Project added = after(project, edit);
    QCOMPARE(pointOf(added, 5000).id, PointId{5000});
    QCOMPARE(added.nextId, PointId{5001});
    QVERIFY(contains(refusal(added, edit), "5000 is in use"));
    edit.id = 0;
    QVERIFY(contains(refusal(project, edit), "cannot be an identifier"));
    edit.id.reset();
    const Project removed = after(added, Remove{{3, {5000}}});
    QCOMPARE(after(removed, edit).nextId, PointId{5002});
  }

  void removedPointsLeaveTheirTraces() {
    const Project project = projectWith();
    const ControlPoint& coarse = project.controls.levels[1][0];
    const PointId member = coarse.mergedFrom.front();
    const Project removed = after(project, Remove{{3, {member}}});
    QVERIFY(!removed.controls.finest().find(member));
    for (const ControlPoint& point : removed.controls.levels[1]) {
      QVERIFY(std::find(point.mergedFrom.begin(), point.mergedFrom.end(), member) == point.mergedFrom.end());
    }
    QVERIFY(levelError(removed) < 1e-13);
  }

  void removalsThatCannotBeDoneAreRefused() {
    const Project project = projectWith(4, 2);
    QVERIFY(contains(refusal(project, Remove{{2, {1, 2, 3, 4}}}), "level 2 without a point"));
    QVERIFY(contains(refusal(after(project, Lock{{2, {1}}, true}), Remove{{2, {1}}}), "locked"));
    QVERIFY(contains(refusal(project, Remove{{2, {77}}}), "no point 77"));
  }

  void levelsAreRebuiltFromTheFinest() {
    const Project project = turned(projectWith());
    const Project four = after(project, SetLevels{4});
    QCOMPARE(static_cast<int>(four.controls.levels.size()), 4);
    QCOMPARE(four.controls.levels[0].size(), 5);
    QVERIFY(levelError(four) < 1e-12);
    const Project one = after(four, SetLevels{1});
    QCOMPARE(static_cast<int>(one.controls.levels.size()), 1);
    QVERIFY(one.controls.finest()[0].binding == Binding{});
    QVERIFY(contains(refusal(project, SetLevels{7}), "40 points allow at most 6 levels"));
    QVERIFY(contains(refusal(project, SetLevels{0}), "too few"));
    QVERIFY(contains(refusal(projectWith(1, 1), SetLevels{2}), "1 point allows at most 1 level, each"));
  }

  void levelsThatAreKeptStayAsTheyAre() {
    Project project = turned(projectWith());
    const PointId strong = project.controls.levels[0][1].id;
    const PointId named = project.controls.levels[1][2].id;
    project = after(project, Strength{{1, {strong}}, 3.0});
    project = after(project, Rename{2, named, "Neck"});
    project = after(project, Enable{{2, {project.controls.levels[1][3].id}}, false});
    const Project four = after(project, SetLevels{4, true});
    QCOMPARE(four.controls.levels[0].size(), 5);
    QVERIFY(levelError(four) < 1e-12);
    // Back again: every point as it was, whatever it hangs on taken anew.
    const Project three = after(four, SetLevels{3, true});
    for (std::size_t l = 0; l < 3; ++l) {
      QVERIFY(isSameButBinding(four.controls.levels[l + 1], project.controls.levels[l]));
      QVERIFY(isSameButBinding(three.controls.levels[l], project.controls.levels[l]));
    }
    QVERIFY(levelError(three) < 1e-12);
    QVERIFY(
        isSameButBinding(after(project, SetLevels{2, true}).controls.levels[0], project.controls.levels[1]));
    // Several at once, and as many as there are.
    const Project six = after(after(project, SetLevels{1, true}), SetLevels{6, true});
    QCOMPARE(six.controls.levels[0].size(), 1);
    QVERIFY(levelError(six) < 1e-12);
    QVERIFY(after(project, SetLevels{3, true}).controls == project.controls);
    QVERIFY(contains(refusal(project, SetLevels{0, true}), "too few"));
  }

  void pointsMadeByHandStayWhenTheirLevelGoes() {
    Project project = projectWith();
    Add edit;
    edit.level = 1;
    edit.rest = {Vec3(0.5, 0.2, 0.1), 0.6 * Mat3::Identity()};
    edit.id = 700;
    project = after(project, edit);
    const Project two = after(project, SetLevels{2, true});
    QCOMPARE(two.controls.levels[0].size(), project.controls.levels[1].size() + 1);
    QVERIFY(two.controls.levels[0].find(700).has_value());
  }

  void aCoarsestLevelOfOnePointHasNoneAboveIt() {
    Project project = projectWith(4, 2);
    project = after(project, Remove{{1, {project.controls.levels[0][0].id}}});
    QVERIFY(contains(refusal(project, SetLevels{3, true}), "has 1 point, so that there can be 0 coarser ones"));
    QVERIFY(refusal(project, SetLevels{3}).empty());
  }

  void handMadeCoarsePointsSurviveARebuild() {
    Project project = projectWith();
    Add edit;
    edit.level = 2;
    edit.rest = {Vec3(0.5, 0.2, 0.1), 0.6 * Mat3::Identity()};
    edit.id = 700;
    project = after(project, edit);
    QVERIFY(after(project, SetLevels{3}).controls.levels[1].find(700).has_value());
    EditWorkspace workspace;
    const EditResult one = apply(project, SetLevels{1}, workspace);
    QCOMPARE(one.remarks.size(), std::size_t{1});
    QVERIFY(!one.project.controls.finest().find(700));
  }

  void aLockedPointTakesThePlaceOfItsTwinInARebuild() {
    const Project project = projectWith();
    const PointId locked = project.controls.levels[1][0].id;
    const Project rebuilt = after(after(project, Lock{{2, {locked}}, true}), SetLevels{3});
    QCOMPARE(rebuilt.controls.levels[1].size(), project.controls.levels[1].size());
    QCOMPARE(pointOf(rebuilt, locked).mergedFrom, pointOf(project, locked).mergedFrom);
    const auto parents = std::count_if(
        rebuilt.controls.levels[0].begin(), rebuilt.controls.levels[0].end(), [&](const ControlPoint& point) {
          return std::count(point.mergedFrom.begin(), point.mergedFrom.end(), locked) == 1;
        });
    QCOMPARE(parents, 1);
    // With a region of its own it stands beside the one that was merged, for none of the finer points.
    const Frame larger{pointOf(project, locked).rest.center, 1.5 * pointOf(project, locked).rest.axes};
    const Project own =
        after(after(after(project, SetRegion{2, locked, larger}), Lock{{2, {locked}}, true}), SetLevels{3});
    QCOMPARE(own.controls.levels[1].size(), project.controls.levels[1].size() + 1);
    QVERIFY(pointOf(own, locked).mergedFrom.empty());
  }

  void aRebuildGivesEachPointOneParent() {
    Project project = projectWith();
    project = after(project, Lock{{2, {project.controls.levels[1][0].id}}, true});
    for (const int count : {2, 3, 4}) {
      const Project rebuilt = after(project, SetLevels{count});
      for (std::size_t l = 0; l + 1 < rebuilt.controls.levels.size(); ++l) {
        std::multiset<PointId> members;
        for (const ControlPoint& point : rebuilt.controls.levels[l]) {
          members.insert(point.mergedFrom.begin(), point.mergedFrom.end());
        }
        QCOMPARE(members.size(), std::set<PointId>(members.begin(), members.end()).size());
      }
    }
  }

  void changesAreNamedByWhatDiffers() {
    const Project project = projectWith();
    QVERIFY(!changesBetween(project, project).any());
    const ProjectChanges moved =
        changesBetween(project, after(project, Move{{3, {1}}, {Vec3(1, 0, 0)}, Follow::none, {}}));
    QVERIFY(moved.poses && !moved.rest && !moved.structure && !moved.mesh && !moved.attributes);
    const ProjectChanges named = changesBetween(project, after(project, Rename{3, 1, "Neck"}));
    QVERIFY(named.attributes && !named.poses && !named.rest && !named.structure);
    const ProjectChanges kernel = changesBetween(project, after(project, SetKernel{{Kernel::wendland, 3.0}}));
    QVERIFY(kernel.rest && !kernel.structure && !kernel.poses);
    const ProjectChanges removed = changesBetween(project, after(project, Remove{{3, {1}}}));
    QVERIFY(removed.structure);
    Project other = project;
    other.mesh = std::make_shared<const RestMesh>(test::cube());
    QVERIFY(changesBetween(project, other).mesh);
  }

  void unmovedProjectsGiveTheMeshItself() {
    const Project project = projectWith();
    EditWorkspace workspace;
    const DeformedShape shape = deformedShape(project, workspace.weights);
    QVERIFY(shape.positions == project.mesh->positions());
    QVERIFY(shape.gradients.empty());
    const Project moved = after(project, Move{{3, {1}}, {Vec3(0.1, 0, 0)}, Follow::none, {}});
    QCOMPARE(static_cast<Index>(deformedShape(moved, workspace.weights).gradients.size()),
             project.mesh->vertexCount());
  }

 private:
  /// Bindings follow from the coarser level.
  static bool isSameButBinding(const Level& one, const Level& other) {
    for (Index i = 0; i < std::min(one.size(), other.size()); ++i) {
      ControlPoint bound = one[i];
      bound.binding = other[i].binding;
      if (!(bound == other[i])) {
        return false;
      }
    }
    return one.size() == other.size();
  }

  static Project turned(const Project& project) {
    Transform edit;
    edit.where = {3, {1, 2, 3}};
    edit.degrees = 30;
    edit.scale = Vec3(1.1, 1, 0.9);
    return after(project, edit);
  }

  static Project allMoved(const Project& project, const Mat3& linear) {
    Transform edit;
    edit.where.level = 1;
    for (const ControlPoint& point : project.controls.levels[0]) {
      edit.where.points.push_back(point.id);
    }
    const Eigen::AngleAxisd turn(linear / std::cbrt(linear.determinant()));
    edit.rotationAxis = turn.axis();
    edit.degrees = turn.angle() * 180 / M_PI;
    edit.scale = Vec3::Constant(std::cbrt(linear.determinant()));
    edit.pivot = Vec3::Zero();
    edit.spread.master = true;
    return after(project, edit);
  }
};

const test::Registration<EditStructureTest> registration;

}  // namespace pbffd

#include "edit_structure_test.moc"
