#include "core/ffd/deform/deformation.h"
#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <cstring>
#include <random>

namespace pbffd {

using test::after;
using test::contains;
using test::difference;
using test::levelError;
using test::pointOf;
using test::projectWith;
using test::refusal;

/// The invariants of core/equations.md, section Levels.
class LevelsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void interleavedEditsOfAllLevelsKeepTheInvariants() {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      std::mt19937 chance(seed);
      Project project = projectWith();
      EditWorkspace workspace;
      for (int step = 0; step < 40; ++step) {
        const Edit edit = randomEdit(project, chance);
        const Project next = apply(project, edit, workspace).project;
        QVERIFY2(levelError(next) < 1e-11, qPrintable(QString::fromStdString(std::string(nameOf(edit)))));
        if (const auto* posed = std::get_if<SetPose>(&edit.value())) {
          // Frames of the level right after an edit of it are exactly what was asked for.
          QVERIFY(pointOf(next, posed->point).pose == posed->pose);
        }
        requireCoarserUntouched(project, next, edit);
        project = next;
      }
    }
  }

  void weightsThatAreKeptGiveTheSameBits() {
    std::mt19937 chance(9);
    Project kept = projectWith();
    Project fresh = kept;
    EditWorkspace workspace;
    for (int step = 0; step < 30; ++step) {
      const Edit edit = randomEdit(kept, chance);
      kept = apply(kept, edit, workspace).project;
      fresh = after(fresh, edit);
      QVERIFY(kept.controls == fresh.controls);
    }
  }

  void structureEditsKeepTheFinerPoses() {
    Project project = posedProject();
    const PointId coarse = project.controls.levels[0][2].id;
    const std::vector<Edit> edits{
        Remove{{1, {coarse}}},
        Enable{{2, {project.controls.levels[1][3].id}}, false},
        Strength{{1, {project.controls.levels[0][4].id}}, 3.0},
        SetReach{{1, {project.controls.levels[0][4].id}}, Reach::all},
        SetRegion{1, project.controls.levels[0][5].id, {Vec3(0.3, 0.3, 0.3), 0.9 * Mat3::Identity()}},
        SetKernel{{Kernel::wendland, 3.0}},
        SetMaster{0.2, MasterMode::constant},
        SetMaster{0.2, MasterMode::paper},
        SetLevels{4},
        SetLevels{2},
        SetLevels{1},
        Add{1, {Vec3(0.1, 0.9, 0), 0.7 * Mat3::Identity()}, false, false, std::nullopt, ""}};
    for (const Edit& edit : edits) {
      const Project next = after(project, edit);
      for (Index i = 0; i < project.controls.finest().size(); ++i) {
        QVERIFY(next.controls.finest()[i].pose == project.controls.finest()[i].pose);
      }
      QVERIFY(levelError(next) < 1e-12);
    }
  }

  void detailKeepsItsSizeAndTurnsWithItsSurroundings() {
    Project project = projectWith();
    const Frame rest = pointOf(project, 7).rest;
    project = after(project, Move{{3, {7}}, {Vec3(0.2, 0, 0)}, Follow::none, {}});
    Transform turn;
    turn.where.level = 1;
    for (const ControlPoint& point : project.controls.levels[0]) {
      turn.where.points.push_back(point.id);
    }
    turn.degrees = 90;
    turn.pivot = Vec3::Zero();
    turn.spread.master = true;
    const Project turned = after(project, turn);
    const Mat3 quarter = Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()).toRotationMatrix();
    const Vec3 detail = pointOf(turned, 7).pose.center - quarter * rest.center;
    QVERIFY((detail - Vec3(0, 0.2, 0)).norm() < 1e-12);
  }

  void aPointFarFromEveryCoarserRegionKeepsItsInfluence() {
    Project project = projectWith();
    // Ten diagonals away: the paper's reparameterization would lose it.
    project = after(project, Move{{3, {7}}, {Vec3(30, 0, 0)}, Follow::none, {}});
    Move coarse;
    coarse.where.level = 1;
    for (const ControlPoint& point : project.controls.levels[0]) {
      coarse.where.points.push_back(point.id);
    }
    coarse.by = {Vec3(0, 1, 0)};
    coarse.spread.master = true;
    const Project moved = after(project, coarse);
    QVERIFY((pointOf(moved, 7).pose.center - pointOf(project, 7).pose.center - Vec3(0, 1, 0)).norm() < 1e-12);
  }

  void oneMapOfALevelAndTheMasterCarriesTheMesh() {
    for (int level = 1; level <= 3; ++level) {
      Project project = posedProject();
      const Points before = deformed(project);
      Transform edit;
      edit.where.level = level;
      for (const ControlPoint& point : project.controls.levels[level - 1]) {
        edit.where.points.push_back(point.id);
      }
      edit.pivot = Vec3(0.2, 0, 0.1);
      edit.rotationAxis = Vec3(1, 1, 0.5);
      edit.degrees = 70;
      edit.scale = Vec3(1.5, 1.0, 0.7);
      edit.spread.master = true;
      project = after(project, edit);
      const Mat3 linear =
          Eigen::AngleAxisd(70 * M_PI / 180, edit.rotationAxis.normalized()).toRotationMatrix() *
          edit.scale.asDiagonal();
      const Points now = deformed(project);
      for (Index v = 0; v < now.rows(); ++v) {
        const Vec3 expected = *edit.pivot + linear * (before.row(v).transpose() - *edit.pivot);
        QVERIFY((now.row(v).transpose() - expected).norm() < 1e-12 * project.mesh->diagonal());
      }
    }
  }

  void editsThatReachNothingLeaveEveryBit() {
    // Two balls far apart, no master: what happens to one is nothing to the other.
    Project project =
        projectWith(40, 3, test::merged(test::sphere(), test::placedAt(test::sphere(), 1.0, Vec3(50, 0, 0))));
    project = after(project, SetMaster{0.0, MasterMode::constant});
    project.controls.levels.back() = shrunk(project.controls.finest());
    project = after(project, SetLevels{3});
    const Project before = after(project, Move{{3, {1}}, {Vec3(0.01, 0.02, 0)}, Follow::none, {}});
    const ControlPoint& coarse = before.controls.levels[0][0];
    const Project next = after(before, Move{{1, {coarse.id}}, {Vec3(0.5, 0, 0)}, Follow::none, {}});
    int far = 0;
    int moved = 0;
    for (Index i = 0; i < before.controls.finest().size(); ++i) {
      const bool isSame = next.controls.finest().shares(i, before.controls.finest());
      if ((before.controls.finest()[i].rest.center - coarse.rest.center).norm() > 25) {
        QVERIFY(isSame);
        ++far;
      }
      moved += isSame ? 0 : 1;
    }
    QVERIFY2(far >= 10 && moved > 0, qPrintable(QString("%1 far, %2 moved").arg(far).arg(moved)));
  }

  void aDragCostsLittle() {
    Project project = projectWith(200, 3);
    EditWorkspace workspace;
    const auto time = [&](int level) {
      const PointId id = project.controls.levels[level - 1][0].id;
      static_cast<void>(apply(project, Move{{level, {id}}, {Vec3(0.01, 0, 0)}, Follow::frames, {}}, workspace));
      QElapsedTimer timer;
      timer.start();
      constexpr int repeats = 50;
      for (int i = 0; i < repeats; ++i) {
        project =
            apply(project, Move{{level, {id}}, {Vec3(0.001, 0, 0)}, Follow::frames, {}}, workspace).project;
      }
      return static_cast<double>(timer.nsecsElapsed()) / repeats / 1e6;
    };
    const double finest = time(3);
    const double coarsest = time(1);
    qInfo("a drag of one of 200 points: %.3f ms on the finest of 3 levels, %.3f ms on the coarsest", finest,
          coarsest);
    // Far above what it takes, for slow and busy machines.
    QVERIFY(finest < 10.0 && coarsest < 10.0);
  }

 private:
  static Project posedProject() {
    Project project = projectWith();
    project =
        after(project, Move{{1, {project.controls.levels[0][1].id}}, {Vec3(0.2, 0.1, 0)}, Follow::none, {}});
    project =
        after(project, Move{{2, {project.controls.levels[1][3].id}}, {Vec3(0, 0.1, 0.1)}, Follow::none, {}});
    return after(project, Move{{3, {4, 9}}, {Vec3(0.05, 0, 0.1)}, Follow::none, {}});
  }

  static Points deformed(const Project& project) {
    const auto weights =
        parameterize(*project.mesh, project.controls.basis, project.controls.master, project.controls.finest());
    return deformExactly(*project.mesh, project.controls, weights);
  }

  static Level shrunk(Level level) {
    for (Index i = 0; i < level.size(); ++i) {
      ControlPoint point = level[i];
      point.rest.axes = 0.6 * Mat3::Identity();
      point.pose = point.rest;
      level.replace(i, point);
    }
    return level;
  }

  static double uniform(std::mt19937& chance) { return chance() / 4294967296.0; }

  static Vec3 vector(std::mt19937& chance) {
    const double x = uniform(chance) - 0.5;
    const double y = uniform(chance) - 0.5;
    return {x, y, uniform(chance) - 0.5};
  }

  static std::vector<PointId> idsOf(const Level& level) {
    std::vector<PointId> ids;
    for (const ControlPoint& point : level) {
      ids.push_back(point.id);
    }
    return ids;
  }

  static Edit randomEdit(const Project& project, std::mt19937& chance) {
    const int level = 1 + static_cast<int>(chance() % project.controls.levels.size());
    const Level& points = project.controls.levels[level - 1];
    const ControlPoint& one = points[static_cast<Index>(chance() % static_cast<unsigned>(points.size()))];
    switch (chance() % 10) {
      case 0: {
        const Mat3 bend =
            Mat3::Identity() + 0.2 * (Mat3() << vector(chance), vector(chance), vector(chance)).finished();
        return SetPose{level, one.id, {one.pose.center + 0.1 * vector(chance), bend * one.pose.axes}};
      }
      case 1: {
        Transform edit;
        edit.where = {level, {one.id}};
        if (chance() % 2 == 0) {
          edit.where.points = idsOf(points);
          edit.spread.master = chance() % 2 == 0;
        }
        edit.rotationAxis = vector(chance) + Vec3(0, 0, 0.6);
        edit.degrees = 20.0 * uniform(chance);
        edit.scale = Vec3::Constant(1.0 + 0.1 * uniform(chance));
        edit.eachItsOwn = true;
        return edit;
      }
      case 2:
        return SetRegion{level, one.id, {one.rest.center + 0.02 * vector(chance), one.rest.axes}};
      case 3:
        return Strength{{level, {one.id}}, 0.5 + uniform(chance)};
      case 4:
        return Add{level, {vector(chance), 0.5 * Mat3::Identity()}, false, false, std::nullopt, ""};
      case 5: {
        Move edit{{level, idsOf(points)}, {0.05 * vector(chance)}, Follow::frames, {}};
        edit.spread.master = chance() % 2 == 0;
        return edit;
      }
      case 6:
        return Enable{{level, {one.id}}, chance() % 2 == 0};
      default:
        return Move{{level, {one.id}}, {0.1 * vector(chance)}, Follow::frames, {}};
    }
  }

  /// No edit of poses moves a coarser level.
  static void requireCoarserUntouched(const Project& before, const Project& next, const Edit& edit) {
    int level = 0;
    if (const auto* move = std::get_if<Move>(&edit.value())) {
      level = *move->where.level;
    } else if (const auto* transform = std::get_if<Transform>(&edit.value())) {
      level = *transform->where.level;
    } else if (const auto* pose = std::get_if<SetPose>(&edit.value())) {
      level = *pose->level;
    }
    for (int l = 0; l + 1 < level; ++l) {
      for (Index i = 0; i < before.controls.levels[l].size(); ++i) {
        QVERIFY(next.controls.levels[l][i].pose == before.controls.levels[l][i].pose);
      }
    }
  }
};

const test::Registration<LevelsTest> registration;

}  // namespace pbffd

#include "levels_test.moc"
