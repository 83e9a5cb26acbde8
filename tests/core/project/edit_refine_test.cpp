#include "core/mesh/io/mesh_io.h"
#include "core/project/project_file.h"
#include "core/project/shape.h"
#include "tests/core/project/projects.h"
#include "tests/support/bend.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>
#include <set>

namespace pbffd {

using test::after;
using test::contains;
using test::levelError;
using test::pointOf;
using test::refusal;

namespace {

/// A fork, as a file gives it, with control points placed on three levels: 60, 30 and 15.
Project placedFork() {
  static const Project project = [] {
    const Mesh fork = test::fork();
    auto bytes = std::make_shared<const std::string>(encodeMesh(fork, {fork.positions, {}}, MeshFormat::obj));
    Place place;
    place.options.points = 60;
    return after(projectOf(std::make_shared<const RestMesh>(parseMesh(bytes, "fork.obj"))), place);
  }();
  return project;
}

/// The project with every point of a level under the map of its own place, the master under that of its own.
Project bent(const Project& project, std::size_t level, double degrees = 120.0) {
  Group group;
  const Bounds& bounds = project.mesh->bounds();
  for (const ControlPoint& point : project.controls.levels[level]) {
    const Frame pose = moved(point.rest, test::bendAt(point.rest.center, bounds, degrees));
    group.edits.emplace_back(SetPose{static_cast<int>(level) + 1, point.id, pose});
  }
  return after(project, group);
}

std::vector<PointId> someOf(const Level& level, Index step = 3) {
  std::vector<PointId> ids;
  for (Index i = 0; i < level.size(); i += step) {
    ids.push_back(level[i].id);
  }
  return ids;
}

/// How far the surface moves from one to the other, as a share of the diagonal.
double change(const Project& before, const Project& after) {
  WeightCache weights;
  const Points a = deformedShape(before, weights).positions;
  const Points b = deformedShape(after, weights).positions;
  return (b - a).rowwise().norm().maxCoeff() / before.mesh->diagonal();
}

/// Whether each point of each level but the coarsest is in just one list of the level above.
bool eachIsMemberOnce(const ControlSet& set) {
  for (std::size_t l = 1; l < set.levels.size(); ++l) {
    std::multiset<PointId> members;
    for (const ControlPoint& point : set.levels[l - 1]) {
      members.insert(point.mergedFrom.begin(), point.mergedFrom.end());
      if (!std::is_sorted(point.mergedFrom.begin(), point.mergedFrom.end())) {
        return false;
      }
    }
    std::multiset<PointId> finer;
    for (const ControlPoint& point : set.levels[l]) {
      finer.insert(point.id);
    }
    if (members != finer) {
      return false;
    }
  }
  return true;
}

}  // namespace

class EditRefineTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pointsThatAreThereStayAndNewOnesFollow() {
    const Project project = bent(placedFork(), 2);
    const Level& before = project.controls.finest();
    const std::vector<PointId> ids = someOf(before);
    const Project refined = after(project, Refine{{3, ids}, 3});
    const Level& finest = refined.controls.finest();
    QCOMPARE(finest.size(), before.size() + 2 * static_cast<Index>(ids.size()));
    for (Index i = 0; i < before.size(); ++i) {
      QVERIFY(finest.shares(i, before));
    }
    for (Index i = before.size(); i < finest.size(); ++i) {
      QCOMPARE(finest[i].id, project.nextId + i - before.size());
    }
    QCOMPARE(refined.nextId, project.nextId + finest.size() - before.size());
    QVERIFY(levelError(refined) < 1e-12);
    QVERIFY(change(project, refined) <= 0.005);
    QVERIFY(change(project, refined) > 0.0);
  }

  void affineDeformationDoesNotChangeAtAll() {
    const Project project = placedFork();
    Transform map;
    for (const ControlPoint& point : project.controls.finest()) {
      map.where.points.push_back(point.id);
    }
    map.pivot = Vec3(0.3, -0.2, 0.1);
    map.scale = Vec3(1.5, 0.7, 1.1);
    map.rotationAxis = Vec3(1, 2, 3);
    map.degrees = 77;
    map.spread.master = true;
    const Project moved = after(project, map);
    const Project refined = after(moved, Refine{{std::nullopt, someOf(moved.controls.finest(), 2)}, 2});
    QVERIFY(change(moved, refined) < 1e-12);
    QVERIFY(levelError(refined) < 1e-12);
  }

  void nothingMovesWhereNothingIsMoved() {
    const Project project = placedFork();
    for (int level = 1; level <= 3; ++level) {
      const Project refined = after(
          project, Refine{{level, someOf(project.controls.levels[static_cast<std::size_t>(level) - 1])}, 2});
      QVERIFY(isAtRest(refined.controls));
      for (const Level& one : refined.controls.levels) {
        for (const ControlPoint& point : one) {
          QVERIFY(point.pose == point.rest);
          QVERIFY(point.binding.local == identityMap());
        }
      }
    }
  }

  void coarserLevelLeavesTheFinerPosesAndTheSurface() {
    for (const std::size_t moved : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
      const Project project = bent(placedFork(), moved, 60.0);
      for (std::size_t level = 0; level < 2; ++level) {
        const Project refined =
            after(project, Refine{{static_cast<int>(level) + 1, someOf(project.controls.levels[level])}, 3});
        QVERIFY(refined.controls.levels[level].size() > project.controls.levels[level].size());
        for (std::size_t l = level + 1; l < 3; ++l) {
          for (Index i = 0; i < project.controls.levels[l].size(); ++i) {
            QVERIFY(refined.controls.levels[l][i].pose == project.controls.levels[l][i].pose);
          }
        }
        QCOMPARE(change(project, refined), 0.0);
        QVERIFY(levelError(refined) < 1e-12);
      }
    }
  }

  void mergedPointsStandForTheNewOnesToo() {
    const Project project = placedFork();
    QVERIFY(eachIsMemberOnce(project.controls));
    for (std::size_t level = 0; level < 3; ++level) {
      const Project refined =
          after(project, Refine{{static_cast<int>(level) + 1, someOf(project.controls.levels[level])}, 3});
      QVERIFY(eachIsMemberOnce(refined.controls));
    }
    const PointId id = project.controls.finest()[4].id;
    const Project refined = after(project, Refine{{3, {id}}, 2});
    for (const ControlPoint& parent : refined.controls.levels[1]) {
      const auto holds = [&](PointId member) {
        return std::count(parent.mergedFrom.begin(), parent.mergedFrom.end(), member) > 0;
      };
      QCOMPARE(holds(project.nextId), holds(id));
    }
  }

  void childrenGoToTheNearestOfTheFamily() {
    const Project project = placedFork();
    const ControlPoint& owner = project.controls.levels[0][3];
    const Project refined = after(project, Refine{{1, {owner.id}}, 4});
    std::vector<ControlPoint> family{pointOf(refined, owner.id)};
    for (Index i = project.controls.levels[0].size(); i < refined.controls.levels[0].size(); ++i) {
      family.push_back(refined.controls.levels[0][i]);
      QVERIFY(family.back().kind == PointKind::merged);
    }
    for (const ControlPoint& one : family) {
      for (const PointId child : one.mergedFrom) {
        const Vec3 at = pointOf(refined, child).rest.center;
        for (const ControlPoint& other : family) {
          QVERIFY((one.rest.center - at).norm() <= (other.rest.center - at).norm());
        }
      }
    }
  }

  void noVertexLosesItsLastInfluence() {
    const Project project = placedFork();
    const Project refined = after(project, Refine{{3, someOf(project.controls.finest(), 1)}, 2});
    const auto reached = [](const Project& one) {
      std::set<Index> vertices;
      for (const ControlPoint& point : one.controls.finest()) {
        const Reached part = reachedVertices(*one.mesh, point);
        vertices.insert(part.vertices.begin(), part.vertices.end());
      }
      return vertices;
    };
    QVERIFY(std::ranges::includes(reached(refined), reached(project)));
  }

  void namesAreThoseOfTheRefinedWithANumber() {
    Project project = placedFork();
    const PointId id = project.controls.finest()[0].id;
    const PointId other = project.controls.finest()[1].id;
    project = after(after(project, Rename{3, id, "Neck"}), Rename{3, other, "Neck 2"});
    const Project refined = after(project, Refine{{3, {id}}, 3});
    QCOMPARE(pointOf(refined, id).name, std::string("Neck"));
    QCOMPARE(pointOf(refined, project.nextId).name, std::string("Neck 3"));
    QCOMPARE(pointOf(refined, project.nextId + 1).name, std::string("Neck 4"));
    const PointId nameless = project.controls.finest()[5].id;
    QVERIFY(pointOf(after(project, Refine{{3, {nameless}}, 2}), project.nextId).name.empty());
  }

  void lockedPointsAreRefinedSinceTheyStay() {
    const Project project = placedFork();
    const PointId id = project.controls.finest()[0].id;
    const Project locked = after(project, Lock{{3, {id}}, true});
    const Project refined = after(locked, Refine{{3, {id}}, 2});
    QVERIFY(pointOf(refined, id) == pointOf(locked, id));
    QVERIFY(!pointOf(refined, project.nextId).locked);
  }

  void disabledPointsAreLeftOut() {
    const Project project = placedFork();
    const PointId first = project.controls.finest()[0].id;
    const PointId second = project.controls.finest()[1].id;
    const Project disabled = after(project, Enable{{3, {first}}, false});
    EditWorkspace workspace;
    const EditResult result = apply(disabled, Refine{{3, {first, second}}, 2}, workspace);
    QCOMPARE(result.remarks.size(), std::size_t{1});
    QVERIFY2(contains(result.remarks[0], "1 of the points is disabled"), result.remarks[0].c_str());
    QCOMPARE(result.project.controls.finest().size(), project.controls.finest().size() + 1);
    QVERIFY(contains(refusal(disabled, Refine{{3, {first}}, 2}), "disabled; enable it first"));
  }

  void pointsMadeByHandAreRefinedOnBothSides() {
    Project project = projectOf(std::make_shared<const RestMesh>(test::sphere()));
    Add add;
    add.rest = {Vec3(0, 0, 1.01), 0.8 * Mat3::Identity()};
    project = after(project, add);
    const Project refined = after(project, Refine{{1, {1}}, 4});
    QCOMPARE(refined.controls.finest().size(), 4);
    for (const ControlPoint& point : refined.controls.finest()) {
      QVERIFY(point.kind == PointKind::manual);
    }
    // An open sheet has no inside.
    Project sheet = projectOf(std::make_shared<const RestMesh>(test::sheet()));
    add.rest = {Vec3(0, 0, 0.05), 0.5 * Mat3::Identity()};
    QCOMPARE(after(after(sheet, add), Refine{{1, {1}}, 3}).controls.finest().size(), 3);
  }

  void whatCannotBeRefinedIsRefused() {
    const Project project = placedFork();
    const PointId id = project.controls.finest()[0].id;
    QVERIFY(contains(refusal(project, Refine{{3, {9999}}, 2}), "there is no point 9999 on level 3"));
    QVERIFY(contains(refusal(project, Refine{{2, {id}}, 2}), "is on level 3, not on level 2"));
    QVERIFY(contains(refusal(project, Refine{{7, {id}}, 2}), "there is no level 7"));
    QVERIFY(contains(refusal(project, Refine{{3, {}}, 2}), "names no points"));
    QVERIFY(contains(refusal(project, Refine{{3, {id, id}}, 2}), "twice"));
    for (const int factor : {-1, 0, 1, 65}) {
      QVERIFY(contains(refusal(project, Refine{{3, {id}}, factor}), "it must be 2 to 64"));
    }
    Project curve = project;
    ControlPoint point = curve.controls.finest()[0];
    point.kind = PointKind::curve;
    curve.controls.levels[2].replace(0, point);
    QVERIFY(contains(refusal(curve, Refine{{3, {id}}, 2}), "is of a curve"));
  }

  void tooManyPointsAreRefused() {
    const Project project = test::projectWith(400, 1);
    const std::string message = refusal(project, Refine{{1, someOf(project.controls.finest(), 1)}, 64});
    QVERIFY2(contains(message, "25,600 points of one level, more than 20,000"), message.c_str());
  }

  void regionWithoutRoomIsRefused() {
    Project project = projectOf(std::make_shared<const RestMesh>(test::sphere()));
    Add add;
    add.rest = {Vec3(10, 0, 0), 0.5 * Mat3::Identity()};
    project = after(project, add);
    const std::string message = refusal(project, Refine{{1, {1}}, 2});
    QVERIFY2(contains(message, "no room for more points in the region of point 1"), message.c_str());
  }

  void meshWithoutASurfaceIsRefused() {
    Mesh cloud = test::sphere();
    cloud.faces = {};
    Project project = projectOf(std::make_shared<const RestMesh>(std::move(cloud)));
    Add add;
    add.rest = {Vec3(0, 0, 1), 0.5 * Mat3::Identity()};
    project = after(project, add);
    QVERIFY(contains(refusal(project, Refine{{1, {1}}, 2}), "no faces"));
  }

  void resultDoesNotDependOnWhatTheWorkspaceKept() {
    const Project project = bent(placedFork(), 1);
    const Refine edit{{3, someOf(project.controls.finest())}, 2};
    EditWorkspace workspace;
    const Project first = apply(project, edit, workspace).project;
    const Project second = apply(project, edit, workspace).project;
    QVERIFY(first.controls == second.controls);
    QVERIFY(first.controls == after(project, edit).controls);
  }

  void cancelledRefinementThrows() {
    const Project project = placedFork();
    EditWorkspace workspace;
    Progress handle;
    const Progress progress([&](std::string_view stage, double) {
      if (stage == "Refining: places") {
        handle.cancel();
      }
    });
    handle = progress;
    QVERIFY_EXCEPTION_THROWN(
        apply(project, Refine{{3, {project.controls.finest()[0].id}}, 2}, workspace, progress), Cancelled);
  }

  void refinedProjectComesBackFromItsFile() {
    const Project project = bent(placedFork(), 2);
    const Project refined = after(project, Refine{{3, someOf(project.controls.finest())}, 2});
    const QTemporaryDir folder;
    const auto path = folder.filePath("refined.pbffd").toStdString();
    saveProject(path, refined);
    const Project back = loadProject(path).project;
    QVERIFY(back.controls == refined.controls);
    QCOMPARE(back.nextId, refined.nextId);
  }

  void editsAfterItFindTheNewPoints() {
    Project project = placedFork();
    const PointId made = project.nextId;
    project = after(project, Refine{{3, {project.controls.finest()[0].id}}, 2});
    Move move{{3, {made}}, {Vec3(0.1, 0, 0)}, Follow::none, {}};
    const Project moved = after(project, move);
    QVERIFY(change(project, moved) > 0.0);
    // Coarser levels carry it.
    Transform turn;
    turn.where = {1, someOf(project.controls.levels[0], 1)};
    turn.degrees = 30;
    turn.spread.master = true;
    QVERIFY(!(pointOf(after(moved, turn), made).pose == pointOf(moved, made).pose));
    QVERIFY(levelError(after(moved, turn)) < 1e-12);
    QCOMPARE(after(moved, Remove{{3, {made}}}).controls.finest().size(), moved.controls.finest().size() - 1);
  }
};

const test::Registration<EditRefineTest> registration;

}  // namespace pbffd

#include "edit_refine_test.moc"
