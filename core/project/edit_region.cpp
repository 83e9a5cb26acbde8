#include "core/base/error.h"
#include "core/base/text.h"
#include "core/ffd/placement/placement.h"
#include "core/project/edit_functions.h"

#include <functional>

// Edits of what weights depend on: regions, influence, kernel, master. Each point keeps its transform.

namespace pbffd {
namespace {

/// The controls with each of the points changed.
ControlSet withPoints(const EditScope& scope, const PointSelection& where,
                      const std::function<void(ControlPoint&)>& change) {
  ControlSet edited = scope.before.controls;
  const SelectedPlaces selected = selectedPlaces(edited, where);
  Level& level = edited.levels[selected.level];
  for (const Index place : selected.places) {
    ControlPoint point = level[place];
    change(point);
    if (!(point == level[place])) {
      level.replace(place, std::move(point));
    }
  }
  return edited;
}

}  // namespace

Project applied(const EditScope& scope, const SetRegion& edit) {
  ControlSet edited = scope.before.controls;
  const Index level = placeOfLevel(edited, edit.level);
  const Index place = placeOfPoint(edited, level, edit.point);
  requireRest(edit.rest);
  ControlPoint point = edited.levels[level][place];
  if (point.locked) {
    throw InvalidInput(format("point {} is locked", point.id));
  }
  setRest(point, edit.rest);
  edited.levels[level].replace(place, std::move(point));
  return withStructure(scope, std::move(edited));
}

Project applied(const EditScope& scope, const Enable& edit) {
  return withStructure(
      scope, withPoints(scope, edit.where, [&](ControlPoint& point) { point.enabled = edit.enabled; }));
}

Project applied(const EditScope& scope, const Strength& edit) {
  requireStrength(edit.value);
  return withStructure(
      scope, withPoints(scope, edit.where, [&](ControlPoint& point) { point.strength = edit.value; }));
}

Project applied(const EditScope& scope, const SetReach& edit) {
  return withStructure(scope,
                       withPoints(scope, edit.where, [&](ControlPoint& point) { point.reach = edit.value; }));
}

Project applied(const EditScope& scope, const Lock& edit) {
  return withControls(scope,
                      withPoints(scope, edit.where, [&](ControlPoint& point) { point.locked = edit.locked; }));
}

Project applied(const EditScope& scope, const Rename& edit) {
  return withControls(scope, withPoints(scope, {edit.level, {edit.point}},
                                        [&](ControlPoint& point) { point.name = edit.name; }));
}

Project applied(const EditScope& scope, const SetMaster& edit) {
  requireFinite(edit.value, "the master's value");
  if (edit.value < 0.0) {
    throw InvalidInput(format("the master's value is {:g}; it must be 0 or more", edit.value));
  }
  ControlSet edited = scope.before.controls;
  edited.master.value = edit.value;
  edited.master.mode = edit.mode;
  return withStructure(scope, std::move(edited));
}

Project applied(const EditScope& scope, const SetKernel& edit) {
  requireFinite(edit.basis.sigma, "sigma");
  if (!(edit.basis.sigma > 0.0)) {
    throw InvalidInput(format("sigma is {:g}; it must be above 0", edit.basis.sigma));
  }
  ControlSet edited = scope.before.controls;
  edited.basis = edit.basis;
  return withStructure(scope, std::move(edited));
}

}  // namespace pbffd
