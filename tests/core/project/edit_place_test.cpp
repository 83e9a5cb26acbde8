#include "core/base/figures.h"
#include "core/base/text.h"
#include "core/project/mirror.h"
#include "core/project/shape.h"
#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <set>

namespace pbffd {

using test::after;
using test::contains;
using test::difference;
using test::levelError;
using test::pointOf;
using test::refusal;

class EditPlaceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void placingFillsTheLevels() {
    const Project project = placed();
    QCOMPARE(static_cast<int>(project.controls.levels.size()), 3);
    QCOMPARE(project.controls.levels[2].size(), 60);
    QCOMPARE(project.controls.levels[1].size(), 30);
    QCOMPARE(project.controls.levels[0].size(), 15);
    QCOMPARE(project.nextId, PointId{106});
    QVERIFY(project.placement == options());
    QVERIFY(isAtRest(project.controls));
    QVERIFY(levelError(project) == 0.0);
  }

  void sameOptionsGiveTheSameProject() { QVERIFY(placed().controls == placed().controls); }

  void identifiersAreNeverReused() {
    const Project first = placed();
    const Project second = after(first, Place{options(), false, std::nullopt});
    std::set<PointId> ids;
    for (const Level& level : second.controls.levels) {
      for (const ControlPoint& point : level) {
        QVERIFY(point.id >= first.nextId);
        QVERIFY(ids.insert(point.id).second);
      }
    }
  }

  void handMadeAndLockedPointsSurvive() {
    Project project = placed();
    project = after(project, Lock{{3, {5}}, true});
    Add add;
    add.rest = {Vec3(0.4, 0.3, 0), 0.5 * Mat3::Identity()};
    add.id = 900;
    project = after(project, add);
    add.id = 901;
    add.level = 1;
    project = after(project, add);
    const Project again = after(project, Place{options(), false, std::nullopt});
    QVERIFY(pointOf(again, 900).rest == add.rest);
    QVERIFY(again.controls.levels[0].find(901).has_value());
    QVERIFY(pointOf(again, 5).locked);
    QVERIFY(!again.controls.finest().find(6));
    QVERIFY(levelError(again) < 1e-13);
  }

  void placingAgainIsAReset() {
    const Project bent = after(placed(), Move{{3, {1, 2, 3}}, {Vec3(0.1, 0, 0)}, Follow::none, {}});
    QVERIFY(isAtRest(after(bent, Place{options(), false, std::nullopt}).controls));
  }

  void keptEditsCarryTheNewPointsAlong() {
    Project project = placed();
    Transform bend;
    bend.where.level = 1;
    for (const ControlPoint& point : project.controls.levels[0]) {
      bend.where.points.push_back(point.id);
    }
    bend.degrees = 30;
    bend.scale = Vec3(1.2, 1, 0.9);
    bend.pivot = Vec3::Zero();
    bend.spread.master = true;
    project = after(project, bend);
    EditWorkspace workspace;
    const Points before = deformedShape(project, workspace.weights).positions;
    PlacementOptions more = options();
    more.points = 80;
    const Project again = after(project, Place{more, true, std::nullopt});
    // All moved by one map, so that the new points do, and the surface stays.
    const Points now = deformedShape(again, workspace.weights).positions;
    QVERIFY((now - before).cwiseAbs().maxCoeff() < 1e-11);
    QVERIFY(levelError(again) < 1e-11);
  }

  void keptEditsSayHowFarTheShapeDiffers() {
    EditWorkspace workspace;
    const Project rest = placed();
    const Edit again = Place{options(), true, std::nullopt};
    QVERIFY(!says(apply(rest, again, workspace), "edits are kept"));

    const Project bent = after(rest, Move{{3, {1, 2, 3, 4}}, {Vec3(0.3, 0, 0)}, Follow::none, {}});
    Place fewer{options(), true, std::nullopt};
    fewer.options.points = 20;
    const EditResult result = apply(bent, fewer, workspace);
    const Points moved = deformedShape(result.project, workspace.weights).positions -
                         deformedShape(bent, workspace.weights).positions;
    const double greatest = moved.rowwise().norm().maxCoeff();
    QVERIFY(greatest > 1e-3);
    const double share = 100.0 * greatest / bent.mesh->diagonal();
    QVERIFY(says(result, format("differs by at most {}, {} %", figures(greatest), figures(share))));
  }

  void symmetricPlacingMakesPartners() {
    const Project project = after(projectOf(mesh()), Place{options(), false, Axis::y});
    const std::vector<Index> partners =
        mirrorPartners(project.controls.finest(), Axis::y, project.mesh->bounds().center());
    QVERIFY(std::find(partners.begin(), partners.end(), -1) == partners.end());
    QVERIFY(std::abs(project.controls.finest().size() - 60) <= 1);
  }

  void moreLevelsThanPointsAllowAreRefused() {
    PlacementOptions few = options();
    few.points = 5;
    few.levels = 4;
    QVERIFY(contains(refusal(projectOf(mesh()), Place{few, false, std::nullopt}),
                     "5 points allow at most 3 levels"));
    few.points = -1;
    QVERIFY(!refusal(projectOf(mesh()), Place{few, false, std::nullopt}).empty());
  }

  void aMeshWithoutFacesIsRefused() {
    Mesh points = test::sphere();
    points.faces = Polygons();
    const Project project = projectOf(std::make_shared<const RestMesh>(points));
    QVERIFY(!refusal(project, Place{options(), false, std::nullopt}).empty());
  }

 private:
  static bool says(const EditResult& result, const std::string& words) {
    return std::any_of(result.remarks.begin(), result.remarks.end(),
                       [&](const std::string& remark) { return contains(remark, words); });
  }
  static PlacementOptions options() {
    PlacementOptions options;
    options.points = 60;
    return options;
  }
  static std::shared_ptr<const RestMesh> mesh() { return std::make_shared<const RestMesh>(test::cylinder()); }
  static Project placed() { return after(projectOf(mesh()), Place{options(), false, std::nullopt}); }
};

const test::Registration<EditPlaceTest> registration;

}  // namespace pbffd

#include "edit_place_test.moc"
