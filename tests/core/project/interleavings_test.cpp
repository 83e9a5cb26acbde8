#include "core/base/file.h"
#include "core/project/project_file.h"
#include "core/project/shape.h"
#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QTemporaryDir>
#include <QtTest>

#include <random>
#include <set>

namespace pbffd {

using test::levelError;
using test::pointOf;
using test::projectWith;

/// Edits drawn by chance: of poses, regions, influence and structure, on any level.
class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}

  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  double upTo(double size) { return size * (random_() / 4294967296.0); }
  Vec3 vector(double size) {
    const double x = upTo(size) - 0.5 * size;
    const double y = upTo(size) - 0.5 * size;
    return {x, y, upTo(size) - 0.5 * size};
  }

  Edit edit(const Project& project) {
    level_ = 1 + below(static_cast<int>(project.controls.levels.size()));
    const Level& level = project.controls.levels[static_cast<std::size_t>(level_ - 1)];
    one_ = &level[below(level.size())];
    return below(3) < 2 ? poseEdit(level) : structureEdit(project);
  }

 private:
  PointSelection one() const { return {level_, {one_->id}}; }

  Edit poseEdit(const Level& level) {
    switch (below(6)) {
      case 0: {
        const Mat3 bend = Mat3::Identity() + (Mat3() << vector(0.2), vector(0.2), vector(0.2)).finished();
        return SetPose{level_, one_->id, {one_->pose.center + vector(0.1), bend * one_->pose.axes}};
      }
      case 1: {
        Transform edit;
        edit.where = one();
        if (below(2) == 0) {
          edit.where.points.clear();
          for (const ControlPoint& point : level) {
            edit.where.points.push_back(point.id);
          }
          edit.spread.master = below(2) == 0;
        }
        edit.rotationAxis = vector(1.0) + Vec3(0, 0, 0.6);
        edit.degrees = upTo(20.0);
        edit.scale = Vec3::Constant(1.0 + upTo(0.1));
        edit.eachItsOwn = true;
        return edit;
      }
      case 2: {
        Move edit{{level_, {}}, {vector(0.05)}, Follow::frames, {}};
        for (const ControlPoint& point : level) {
          edit.where.points.push_back(point.id);
          edit.spread.weights.push_back(upTo(1.0));
        }
        edit.spread.master = below(2) == 0;
        return edit;
      }
      case 3:
        return below(4) == 0 ? Edit(Reset{}) : Edit(Lock{one(), below(2) == 0});
      default:
        return Move{one(), {vector(0.1)}, Follow::frames, {}};
    }
  }

  Edit structureEdit(const Project& project) {
    switch (below(10)) {
      case 0:
        return SetRegion{level_, one_->id, {one_->rest.center + vector(0.02), 0.9 * one_->rest.axes}};
      case 1:
        return Strength{one(), 0.5 + upTo(1.0)};
      case 2:
        return Add{level_, {vector(1.0), 0.5 * Mat3::Identity()}, below(2) == 0, false, std::nullopt, ""};
      case 3:
        return Remove{one()};
      case 4:
        return Enable{one(), below(2) == 0};
      case 5:
        return SetReach{one(), below(2) == 0 ? Reach::all : Reach::connected};
      case 6:
        return Refine{one(), 2};
      case 7:
        return SetLevels{1 + below(4)};
      case 8:
        return below(2) == 0 ? Edit(SetMaster{upTo(0.2), MasterMode::constant})
                             : Edit(SetKernel{{below(2) == 0 ? Kernel::wendland : Kernel::smooth, 3.0}});
      default: {
        Place edit;
        edit.options = project.placement;
        edit.options.points = 30;
        edit.options.levels = 3;
        edit.keepEdits = true;
        return edit;
      }
    }
  }

  std::mt19937 random_;
  int level_ = 1;
  const ControlPoint* one_ = nullptr;
};

/// The invariants of core/equations.md, section Levels, over everything that can be done to levels, in any
/// order, with undo, redo, saving and opening in between.
class InterleavingsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void invariantsHoldInAnyOrder_data() {
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 6; ++seed) {
      QTest::addRow("%u", seed) << seed;
    }
  }

  void invariantsHoldInAnyOrder() {
    QFETCH(unsigned, seed);
    Chance chance(seed);
    EditWorkspace workspace;
    std::vector<Project> history{projectWith(40, 3, test::sphere(12, 16))};
    int applied = 0;
    for (int step = 0; step < 50; ++step) {
      if (history.size() > 1 && chance.below(8) == 0) {
        undoAndRedo(history, workspace);
      } else if (chance.below(10) == 0) {
        saveAndOpen(history.back());
      } else {
        applied += edit(history, chance, workspace) ? 1 : 0;
      }
      if (QTest::currentTestFailed()) {
        return;
      }
    }
    QVERIFY2(applied > 25, "edits that are refused test little");
  }

 private:
  /// Applies one edit; false where it is refused, which changes nothing.
  bool edit(std::vector<Project>& history, Chance& chance, EditWorkspace& workspace) {
    const Project before = history.back();
    const Edit edit = chance.edit(before);
    edits_.resize(history.size(), edit);
    edits_.back() = edit;
    try {
      history.push_back(apply(before, edit, workspace).project);
    } catch (const InvalidInput&) {
      return false;
    }
    requireInvariants(before, history.back(), edit);
    return true;
  }

  static void requireInvariants(const Project& before, const Project& next, const Edit& edit) {
    const QByteArray name(std::string(nameOf(edit)).c_str());
    // Every pose is M x rest with M = B x local, at any time.
    QVERIFY2(levelError(next) < 1e-11, name);
    // Each point has one parent at most, which is on the next coarser level.
    for (std::size_t l = 0; l < next.controls.levels.size(); ++l) {
      std::set<PointId> members;
      for (const ControlPoint& point : next.controls.levels[l]) {
        for (const PointId member : point.mergedFrom) {
          QVERIFY2(l + 1 < next.controls.levels.size() && next.controls.levels[l + 1].find(member), name);
          QVERIFY2(members.insert(member).second, name);
        }
      }
    }
    // Frames of a level right after an edit of it are what was asked for, and coarser levels stay.
    if (const auto* posed = std::get_if<SetPose>(&edit.value())) {
      QVERIFY(pointOf(next, posed->point).pose == posed->pose);
      requireSamePoses(before, next, 0, static_cast<std::size_t>(*posed->level - 1));
    } else if (const auto* moved = std::get_if<Move>(&edit.value())) {
      requireSamePoses(before, next, 0, static_cast<std::size_t>(*moved->where.level - 1));
    } else if (const auto* turned = std::get_if<Transform>(&edit.value())) {
      requireSamePoses(before, next, 0, static_cast<std::size_t>(*turned->where.level - 1));
    } else if (isOfInfluence(edit)) {
      // What weights depend on leaves every pose of every level.
      requireSamePoses(before, next, 0, next.controls.levels.size());
    }
  }

  static bool isOfInfluence(const Edit& edit) {
    const auto is = [&](auto kind) { return std::holds_alternative<decltype(kind)>(edit.value()); };
    return is(Strength{}) || is(Enable{}) || is(SetReach{}) || is(SetMaster{}) || is(SetKernel{}) || is(Lock{});
  }

  static void requireSamePoses(const Project& before, const Project& next, std::size_t from, std::size_t to) {
    for (std::size_t l = from; l < to; ++l) {
      for (Index i = 0; i < before.controls.levels[l].size(); ++i) {
        QVERIFY(next.controls.levels[l][i].pose == before.controls.levels[l][i].pose);
      }
    }
  }

  /// Undoing is taking the value before; doing the edit again gives the same bits.
  void undoAndRedo(std::vector<Project>& history, EditWorkspace& workspace) const {
    const Project undone = history.back();
    history.pop_back();
    const Project redone = apply(history.back(), edits_[history.size() - 1], workspace).project;
    QVERIFY(redone.controls == undone.controls);
    QCOMPARE(redone.nextId, undone.nextId);
  }

  /// The file holds the levels to the bit, and nothing in it needs mending.
  void saveAndOpen(Project& project) const {
    const std::filesystem::path path = folder_.filePath("levels.pbffd").toStdString();
    saveProject(path, project);
    LoadedProject loaded = loadProject(path);
    QVERIFY(loaded.remarks.empty());
    QVERIFY(loaded.project.controls == project.controls);
    QCOMPARE(loaded.project.nextId, project.nextId);
    project = std::move(loaded.project);
  }

  QTemporaryDir folder_;
  std::vector<Edit> edits_;  ///< entry i led from history[i] to history[i + 1]
};

const test::Registration<InterleavingsTest> registration;

}  // namespace pbffd

#include "interleavings_test.moc"
