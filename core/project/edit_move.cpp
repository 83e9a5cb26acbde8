#include "core/base/error.h"
#include "core/base/figures.h"
#include "core/base/text.h"
#include "core/ffd/levels/frames_follow.h"
#include "core/project/edit_functions.h"
#include "core/project/edit_spread.h"

#include <algorithm>

namespace pbffd {
namespace {

Vec3 withoutComponents(Vec3 vector, const std::vector<Axis>& axes) {
  for (const Axis axis : axes) {
    vector[static_cast<int>(axis)] = 0.0;
  }
  return vector;
}

Vec3 mirrored(Vec3 vector, const std::vector<Axis>& axes) {
  for (const Axis axis : axes) {
    vector[static_cast<int>(axis)] *= -1.0;
  }
  return vector;
}

void requireUsable(const Move& edit) {
  if (edit.by.size() != 1 && edit.by.size() != edit.where.points.size()) {
    throw InvalidInput(format("\"by\" has {} vectors for {} points; give one, or one for each point",
                              edit.by.size(), edit.where.points.size()));
  }
  for (const Vec3& by : edit.by) {
    requireFinite(by, "\"by\"");
  }
}

/// The master goes with the mean of what the points do, as far as the mirror planes keep it.
Vec3 masterShift(const Move& edit) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& by : edit.by) {
    sum += by;
  }
  return withoutComponents(edit.by.size() == 1 ? edit.by[0] : Vec3(sum / static_cast<double>(edit.by.size())),
                           edit.spread.mirror);
}

int posedPoints(const ControlSet& set) {
  int count = 0;
  for (const Level& level : set.levels) {
    count += static_cast<int>(std::count_if(
        level.begin(), level.end(), [](const ControlPoint& point) { return !(point.pose == point.rest); }));
  }
  return count;
}

void putBackToRest(Level& level, Index place) {
  if (!level[place].locked && !(level[place].pose == level[place].rest)) {
    ControlPoint point = level[place];
    point.pose = point.rest;
    level.replace(place, std::move(point));
  }
}

Project withAllPosesAtRest(const EditScope& scope) {
  Project project = scope.before;
  project.controls.master.pose = project.controls.master.rest;
  // Level by level from the coarsest, each carrying the finer ones: locked points move with coarser levels
  // only.
  for (Index l = 0; l < static_cast<Index>(project.controls.levels.size()); ++l) {
    ControlSet edited = project.controls;
    for (Index i = 0; i < edited.levels[l].size(); ++i) {
      putBackToRest(edited.levels[l], i);
    }
    const Project current = l == 0 ? scope.before : project;
    project = withPoses({current, scope.workspace, scope.progress, scope.remarks}, std::move(edited), l);
  }
  if (const int stayed = posedPoints(project.controls); stayed > 0) {
    scope.remarks.push_back(format("{} locked point{} stayed in place; unlock {} to put {} back to rest too.",
                                   counted(stayed), stayed == 1 ? "" : "s", stayed == 1 ? "it" : "them",
                                   stayed == 1 ? "it" : "them"));
  }
  return project;
}

Project withRestPoses(const EditScope& scope, const PointSelection& where, bool master) {
  const SelectedPlaces selected = selectedPlaces(scope.before.controls, where);
  ControlSet edited = scope.before.controls;
  for (const Target& target : targetsOf(scope, selected, {})) {
    putBackToRest(edited.levels[selected.level], target.place);
  }
  if (master) {
    edited.master.pose = edited.master.rest;
  }
  return withPoses(scope, std::move(edited), selected.level);
}

}  // namespace

Project applied(const EditScope& scope, const Move& edit) {
  const ControlSet& before = scope.before.controls;
  const SelectedPlaces selected = selectedPlaces(before, edit.where);
  requireUsable(edit);
  std::vector<Index> places;
  std::vector<Vec3> shifts;
  for (const Target& target : targetsOf(scope, selected, edit.spread)) {
    const Vec3& by = edit.by.size() == 1 ? edit.by[0] : edit.by[target.entry];
    if (target.weight != 0.0) {
      places.push_back(target.place);
      shifts.push_back(mirrored(withoutComponents(target.weight * by, target.onPlanes), target.mirrored));
    }
  }
  ControlSet edited = before;
  Level& level = edited.levels[selected.level];
  std::vector<Mat3> turns(places.size(), Mat3::Identity());
  if (edit.follow == Follow::frames) {
    turns = followingRotations(before.levels[selected.level], places, shifts);
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    ControlPoint point = level[places[k]];
    point.pose.center += shifts[k];
    if (turns[k] != Mat3::Identity()) {
      point.pose.axes = turns[k] * point.pose.axes;
    }
    level.replace(places[k], std::move(point));
  }
  if (edit.spread.master) {
    edited.master.pose.center += masterShift(edit);
  }
  return withPoses(scope, std::move(edited), selected.level);
}

Project applied(const EditScope& scope, const SetPose& edit) {
  ControlSet edited = scope.before.controls;
  const Index level = placeOfLevel(edited, edit.level);
  const Index place = placeOfPoint(edited, level, edit.point);
  requirePose(edit.pose);
  ControlPoint point = edited.levels[level][place];
  if (point.locked) {
    throw InvalidInput(format("point {} is locked", point.id));
  }
  point.pose = edit.pose;
  edited.levels[level].replace(place, std::move(point));
  return withPoses(scope, std::move(edited), level);
}

Project applied(const EditScope& scope, const Reset& edit) {
  return edit.where ? withRestPoses(scope, *edit.where, edit.master) : withAllPosesAtRest(scope);
}

}  // namespace pbffd
