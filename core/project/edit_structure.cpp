#include "core/base/error.h"
#include "core/base/text.h"
#include "core/ffd/deform/inverse.h"
#include "core/ffd/levels/hierarchy.h"
#include "core/project/edit_functions.h"
#include "core/project/edit_survivors.h"
#include "core/project/shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pbffd {
namespace {

bool isInUse(const ControlSet& set, PointId id) {
  return std::any_of(set.levels.begin(), set.levels.end(), [&](const Level& level) { return level.find(id); });
}

/// The axes of a point that brings none: a sphere as placement makes it, from the nearest point of the level.
Mat3 usualAxes(const Project& project, const Level& level, const Vec3& center) {
  constexpr double shareOfDiagonal = 0.1;
  double distance = std::numeric_limits<double>::infinity();
  for (const ControlPoint& point : level) {
    const double other = (point.rest.center - center).norm();
    distance = other > 0.0 ? std::min(distance, other) : distance;
  }
  const double radius = std::isfinite(distance) ? project.placement.radiusFactor * distance
                                                : shareOfDiagonal * project.mesh->diagonal();
  return radius * Mat3::Identity();
}

/// Where on the rest shape a place of the deformed space comes from.
Vec3 restPlace(const EditScope& scope, const Vec3& posed) {
  const Project& before = scope.before;
  const DeformedShape shape = deformedShape(before, scope.workspace.weights, scope.progress);
  const auto place = restPlaceOf(posed, before.mesh, before.controls, shape.positions, scope.progress);
  if (!place) {
    throw InvalidInput(
        format("the deformation leads no place of the rest shape to {:.6g}, {:.6g}, {:.6g}; "
               "choose a place nearer to the surface, or add the point in the rest space",
               posed.x(), posed.y(), posed.z()));
  }
  return *place;
}

PointId idFor(const Project& project, const std::optional<PointId>& wanted) {
  if (!wanted) {
    return project.nextId;
  }
  if (*wanted < 1 || *wanted > greatestPointId) {
    throw InvalidInput(format("{} cannot be an identifier", *wanted));
  }
  if (isInUse(project.controls, *wanted)) {
    throw InvalidInput(format("the identifier {} is in use", *wanted));
  }
  return *wanted;
}

/// So many levels more, in front of those that there are.
void addCoarserLevels(ControlSet& set, int count, PointId& nextId, RegionShape shape) {
  const Level& coarsest = set.levels.front();
  if (const int greatest = greatestLevelCount(coarsest.size()) - 1; count > greatest) {
    throw InvalidInput(
        format("the coarsest level has {} point{}, so that there can be {} coarser one{} and not {}",
               coarsest.size(), coarsest.size() == 1 ? "" : "s", greatest, greatest == 1 ? "" : "s", count));
  }
  const std::vector<Level> made = buildLevels(coarsest, count + 1, nextId, shape);
  set.levels.insert(set.levels.begin(), made.begin(), made.end() - 1);
}

}  // namespace

Project applied(const EditScope& scope, const Add& edit) {
  const Project& before = scope.before;
  ControlSet edited = before.controls;
  const Index level = placeOfLevel(edited, edit.level);
  ControlPoint point;
  point.id = idFor(before, edit.id);
  point.name = edit.name;
  point.kind = PointKind::manual;
  point.reach = before.placement.reach;
  point.rest = edit.rest;
  requireFinite(point.rest.center, "the centre");
  if (edit.posed) {
    point.rest.center = restPlace(scope, edit.rest.center);
  }
  if (edit.defaultAxes) {
    point.rest.axes = usualAxes(before, edited.levels[level], point.rest.center);
  }
  requireRest(point.rest);
  Points place(1, 3);
  place.row(0) = point.rest.center;
  point.pose = moved(point.rest, blendedMapsAt(scope, edited, place)[0]);
  const PointId id = point.id;
  edited.levels[level].append(std::move(point));
  Project after = withStructure(scope, std::move(edited));
  after.nextId = std::max(before.nextId, id + 1);
  return after;
}

Project applied(const EditScope& scope, const Remove& edit) {
  ControlSet edited = scope.before.controls;
  const SelectedPlaces selected = selectedPlaces(edited, edit.where);
  const Level& level = edited.levels[selected.level];
  if (static_cast<Index>(selected.places.size()) == level.size()) {
    throw InvalidInput(
        format("it would leave level {} without a point; with fewer levels (\"levels\") or by "
               "disabling points the same can be done",
               selected.level + 1));
  }
  std::vector<bool> leaves(level.size(), false);
  for (const Index place : selected.places) {
    if (level[place].locked) {
      throw InvalidInput(format("point {} is locked", level[place].id));
    }
    leaves[place] = true;
  }
  Level kept;
  for (Index i = 0; i < level.size(); ++i) {
    if (!leaves[i]) {
      kept.append(level, i);
    }
  }
  edited.levels[selected.level] = std::move(kept);
  return withStructure(scope, std::move(edited));
}

Project applied(const EditScope& scope, const SetLevels& edit) {
  const Project& before = scope.before;
  requireLevelCount(edit.count, before.controls.finest().size());
  const int formerCount = static_cast<int>(before.controls.levels.size());
  const int kept = edit.keep ? std::min(edit.count, formerCount) : 1;
  Project after = before;
  ControlSet edited = before.controls;
  edited.levels.erase(edited.levels.begin(), edited.levels.end() - kept);
  addCoarserLevels(edited, edit.count - kept, after.nextId, before.placement.regions);
  poseByDeformation(scope, before.controls, edited, static_cast<std::size_t>(edit.count - kept));
  addCoarserSurvivors(scope, before.controls, edited, kept);
  after.controls = withStructure(scope, std::move(edited)).controls;
  return after;
}

}  // namespace pbffd
