#include "ui/models/scene_switches.h"

#include "ui/document/document.h"
#include "ui/document/view_state.h"

#include <QCoreApplication>

#include <algorithm>

namespace pbffd::ui {
namespace {

std::string translated(const char* text) {
  return QCoreApplication::translate("SceneSwitches", text).toStdString();
}

}  // namespace

const Level& SceneSwitches::level(int place) const {
  return document_.shown().controls.levels[static_cast<std::size_t>(place)];
}

bool SceneSwitches::isShown(const ScenePlace& place) const {
  switch (place.row) {
    case SceneRow::mesh:
      return view_.isMeshShown();
    case SceneRow::controls:
      return view_.areControlsShown();
    case SceneRow::level:
      return view_.isLevelShown(place.level + 1);
    case SceneRow::group: {
      const auto& places = rows_.places(place.level, place.kind);
      return std::any_of(places.begin(), places.end(),
                         [&](Index at) { return view_.isPointEyeOpen(level(place.level)[at].id); });
    }
    case SceneRow::point:
      break;
  }
  return view_.isPointEyeOpen(level(place.level)[place.point].id);
}

void SceneSwitches::setShown(const ScenePlace& place, bool shown) {
  switch (place.row) {
    case SceneRow::mesh:
      return view_.setMeshShown(shown);
    case SceneRow::controls:
      return view_.setControlsShown(shown);
    case SceneRow::level:
      return view_.setLevelShown(place.level + 1, shown);
    default:
      return view_.setPointsShown(rows_.pointsBelow(place, document_.shown().controls), shown);
  }
}

bool SceneSwitches::isAllLocked(int levelPlace, const PointKind* kind) const {
  for (const ControlPoint& point : level(levelPlace)) {
    if (!point.locked && (kind == nullptr || point.kind == *kind)) {
      return false;
    }
  }
  return !level(levelPlace).empty();
}

bool SceneSwitches::isLocked(const ScenePlace& place) const {
  switch (place.row) {
    case SceneRow::mesh:
      return true;
    case SceneRow::controls:
      for (int l = 0; l < rows_.levelCount(); ++l) {
        if (!isAllLocked(l, nullptr)) {
          return false;
        }
      }
      return rows_.levelCount() > 0;
    case SceneRow::level:
      return isAllLocked(place.level, nullptr);
    case SceneRow::group:
      return isAllLocked(place.level, &place.kind);
    case SceneRow::point:
      break;
  }
  return level(place.level)[place.point].locked;
}

bool SceneSwitches::setLocked(const ScenePlace& place, bool locked) {
  const ControlSet& set = document_.shown().controls;
  if (place.row == SceneRow::mesh) {
    return false;
  }
  if (place.row != SceneRow::controls) {
    return document_.perform(Lock{{place.level + 1, rows_.pointsBelow(place, set)}, locked});
  }
  Group all;
  all.text = translated(locked ? "Lock all points" : "Unlock all points");
  for (int l = 0; l < rows_.levelCount(); ++l) {
    if (const auto points = rows_.pointsBelow({SceneRow::level, l}, set); !points.empty()) {
      all.edits.push_back(Lock{{l + 1, points}, locked});
    }
  }
  return !all.edits.empty() && document_.perform(all);
}

bool SceneSwitches::isEnabled(const ScenePlace& place) const {
  return place.row != SceneRow::point || level(place.level)[place.point].enabled;
}

bool SceneSwitches::setEnabled(const ScenePlace& place, bool enabled) {
  return place.row == SceneRow::point &&
         document_.perform(Enable{{place.level + 1, {level(place.level)[place.point].id}}, enabled});
}

}  // namespace pbffd::ui
