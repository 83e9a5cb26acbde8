#include "core/project/edit_scope.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/ffd/frame_checks.h"
#include "core/ffd/levels/hierarchy.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

namespace pbffd {
namespace {

[[noreturn]] void failForMissing(const ControlSet& set, Index level, PointId id) {
  for (std::size_t other = 0; other < set.levels.size(); ++other) {
    if (set.levels[other].find(id)) {
      throw InvalidInput(format("point {} is on level {}, not on level {}", id, other + 1, level + 1));
    }
  }
  throw InvalidInput(format("there is no point {} on level {}", id, level + 1));
}

void requireUsablePose(const ControlPoint& point, std::size_t level) {
  if (!isFinite(point.pose)) {
    throw InvalidInput(format("it would move point {} on level {} out of all bounds", point.id, level + 1));
  }
  if (!isInvertible(point.pose.axes)) {
    throw InvalidInput(
        format("it would flatten point {} on level {}: its pose would be singular", point.id, level + 1));
  }
}

void requireUsablePoses(const ControlSet& before, const ControlSet& after) {
  for (std::size_t l = 0; l < after.levels.size(); ++l) {
    const Level& level = after.levels[l];
    for (Index i = 0; i < level.size(); ++i) {
      const bool isOld =
          l < before.levels.size() && i < before.levels[l].size() && level.shares(i, before.levels[l]);
      if (!isOld) {
        requireUsablePose(level[i], l);
      }
    }
  }
  if (!isFinite(after.master.pose) || !isInvertible(after.master.pose.axes)) {
    throw InvalidInput("it would flatten the master control point, or move it out of all bounds");
  }
}

/// What a merged point stands for are points of the next finer level that are still there.
void dropMissingMembers(ControlSet& set) {
  for (std::size_t l = 0; l < set.levels.size(); ++l) {
    std::unordered_set<PointId> finer;
    if (l + 1 < set.levels.size()) {
      for (const ControlPoint& point : set.levels[l + 1]) {
        finer.insert(point.id);
      }
    }
    Level& level = set.levels[l];
    for (Index i = 0; i < level.size(); ++i) {
      const auto isMissing = [&](PointId id) { return !finer.contains(id); };
      const auto& members = level[i].mergedFrom;
      if (std::any_of(members.begin(), members.end(), isMissing)) {
        ControlPoint point = level[i];
        std::erase_if(point.mergedFrom, isMissing);
        level.replace(i, std::move(point));
      }
    }
  }
}

/// The coarsest level hangs on nothing, every other point on the place of its rest centre.
void placeBindings(ControlSet& set) {
  for (std::size_t l = 0; l < set.levels.size(); ++l) {
    Level& level = set.levels[l];
    for (Index i = 0; i < level.size(); ++i) {
      const Binding wanted = l == 0 ? Binding{} : Binding{level[i].rest.center, level[i].binding.local};
      if (!(level[i].binding == wanted)) {
        ControlPoint point = level[i];
        point.binding = wanted;
        level.replace(i, std::move(point));
      }
    }
  }
}

std::shared_ptr<const std::vector<PointWeights>> bindingsOf(const EditScope& scope, const ControlSet& set) {
  if (set.levels.size() < 2) {
    return std::make_shared<const std::vector<PointWeights>>();
  }
  return scope.workspace.weights.bindings(scope.before.mesh, set, scope.progress);
}

}  // namespace

Index placeOfLevel(const ControlSet& set, const std::optional<int>& level) {
  const int count = static_cast<int>(set.levels.size());
  if (!level) {
    return count - 1;
  }
  if (*level < 1 || *level > count) {
    throw InvalidInput(format("there is no level {}; the project has {} (1 is the coarsest)", *level,
                              count == 1 ? "one level" : format("levels 1 to {}", count)));
  }
  return *level - 1;
}

Index placeOfPoint(const ControlSet& set, Index level, PointId id) {
  const auto place = set.levels[level].find(id);
  if (!place) {
    failForMissing(set, level, id);
  }
  return *place;
}

SelectedPlaces selectedPlaces(const ControlSet& set, const PointSelection& where) {
  SelectedPlaces selected;
  selected.level = placeOfLevel(set, where.level);
  if (where.points.empty()) {
    throw InvalidInput("it names no points");
  }
  const Level& level = set.levels[selected.level];
  std::unordered_map<PointId, Index> placeOf;
  placeOf.reserve(static_cast<std::size_t>(level.size()));
  for (Index i = 0; i < level.size(); ++i) {
    placeOf.emplace(level[i].id, i);
  }
  std::unordered_set<PointId> seen;
  for (const PointId id : where.points) {
    const auto found = placeOf.find(id);
    if (found == placeOf.end()) {
      failForMissing(set, selected.level, id);
    }
    if (!seen.insert(id).second) {
      throw InvalidInput(format("it names point {} twice", id));
    }
    selected.places.push_back(found->second);
  }
  return selected;
}

void requireLevelCount(int count, Index finestPoints) {
  if (count < 1) {
    throw InvalidInput(format("{} levels are too few; there is always at least one", count));
  }
  const int greatest = greatestLevelCount(finestPoints);
  if (count > greatest) {
    throw InvalidInput(format(
        "{} point{} allow{} at most {} level{}, each with half as many as the next; {} were asked for. Ask "
        "for fewer levels, or place more points first",
        finestPoints, finestPoints == 1 ? "" : "s", finestPoints == 1 ? "s" : "", greatest,
        greatest == 1 ? "" : "s", count));
  }
}

void requireFinite(const Vec3& vector, const char* what) {
  if (!vector.allFinite()) {
    throw InvalidInput(format("{} is not finite", what));
  }
}

void requireFinite(double number, const char* what) {
  if (!std::isfinite(number)) {
    throw InvalidInput(format("{} is not finite", what));
  }
}

void requireRest(const Frame& frame) {
  requireFinite(frame.center, "the centre");
  if (!frame.axes.allFinite()) {
    throw InvalidInput("an axis is not finite");
  }
  if (!haveLengths(frame.axes)) {
    throw InvalidInput("an axis of the region has no length");
  }
  if (!areOrthogonal(frame.axes)) {
    throw InvalidInput("the axes of the region are not at right angles to each other (to 1e-9)");
  }
}

void requirePose(const Frame& frame) {
  requireFinite(frame.center, "the centre");
  if (!frame.axes.allFinite()) {
    throw InvalidInput("an axis is not finite");
  }
  if (!isInvertible(frame.axes)) {
    throw InvalidInput("the axes of the pose are singular: they span no volume");
  }
}

void requireStrength(double strength) {
  requireFinite(strength, "the strength");
  if (!(strength > 0.0)) {
    throw InvalidInput(format("a strength of {:g} is not above 0; disable the points instead", strength));
  }
  constexpr double greatest = 1e100;
  if (strength > greatest || strength < 1.0 / greatest) {
    throw InvalidInput(
        format("a strength of {:g} is not between {:g} and {:g}", strength, 1.0 / greatest, greatest));
  }
}

void setRest(ControlPoint& point, const Frame& rest) {
  point.pose = moved(rest, point.map());
  point.rest = rest;
}

Project withPoses(const EditScope& scope, ControlSet edited, Index level) {
  const ControlSet& before = scope.before.controls;
  const auto bindings = bindingsOf(scope, before);
  // The coarser levels stay where they are, but hang on the master as well.
  const bool masterMoved = !(before.master.pose == edited.master.pose);
  for (Index l = masterMoved ? 1 : level; l <= level; ++l) {
    rebind(edited, l, *bindings);
  }
  carryDown(before, edited, level, *bindings);
  requireUsablePoses(before, edited);
  return withControls(scope, std::move(edited));
}

Project withStructure(const EditScope& scope, ControlSet edited) {
  dropMissingMembers(edited);
  placeBindings(edited);
  const auto bindings = bindingsOf(scope, edited);
  for (Index l = 1; l < static_cast<Index>(edited.levels.size()); ++l) {
    rebind(edited, l, *bindings);
  }
  requireUsablePoses(scope.before.controls, edited);
  return withControls(scope, std::move(edited));
}

Project withControls(const EditScope& scope, ControlSet edited) {
  Project after = scope.before;
  after.controls = std::move(edited);
  return after;
}

std::vector<AffineMap> blendedMapsAt(const EditScope& scope, const ControlSet& set, const Points& places) {
  const Level& level = set.finest();
  const PointWeights weights =
      weightsAt(places, *scope.before.mesh, set.basis, set.master, level, scope.progress);
  const LevelMaps maps = mapsOf(set, level);
  std::vector<AffineMap> blended;
  blended.reserve(static_cast<std::size_t>(places.rows()));
  for (Index i = 0; i < static_cast<Index>(places.rows()); ++i) {
    blended.push_back(blendedMap(weights, i, maps));
    if (!isInvertible(blended.back().leftCols<3>())) {
      throw InvalidInput(format(
          "the shape is folded flat at {:.4g}, {:.4g}, {:.4g}, so that a new point there has no usable pose",
          places(i, 0), places(i, 1), places(i, 2)));
    }
  }
  return blended;
}

}  // namespace pbffd
