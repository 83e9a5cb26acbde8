#include "ui/models/scene_rows.h"

#include <algorithm>

namespace pbffd::ui {

SceneRows::SceneRows(const ControlSet& set, const PointFilter& filter) : levels_(set.levels.size()) {
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    LevelRows& rows = levels_[l];
    const Level& level = set.levels[l];
    for (Index place = 0; place < level.size(); ++place) {
      const ControlPoint& point = level[place];
      if (filter.isEmpty() || filter.accepts(point)) {
        auto& places = rows.places[static_cast<std::size_t>(point.kind)];
        rows.spots[point.id] = {point.kind, static_cast<int>(places.size())};
        places.push_back(place);
      }
    }
    for (int kind = 0; kind < kindCount; ++kind) {
      if (!rows.places[static_cast<std::size_t>(kind)].empty()) {
        rows.kinds.push_back(static_cast<PointKind>(kind));
      }
    }
  }
}

int SceneRows::rowOfGroup(int level, PointKind kind) const {
  const auto& kinds = at(level).kinds;
  return static_cast<int>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
}

SceneRows::Spot SceneRows::find(int level, PointId point) const {
  if (level < 0 || level >= levelCount()) {
    return {};
  }
  const auto found = at(level).spots.find(point);
  return found == at(level).spots.end() ? Spot{} : found->second;
}

std::vector<PointId> SceneRows::pointsBelow(const ScenePlace& place, const ControlSet& set) const {
  std::vector<PointId> points;
  const auto addKind = [&](int level, PointKind kind) {
    for (const Index at : places(level, kind)) {
      points.push_back(set.levels[static_cast<std::size_t>(level)][at].id);
    }
  };
  const auto addLevel = [&](int level) {
    for (const PointKind kind : at(level).kinds) {
      addKind(level, kind);
    }
  };
  switch (place.row) {
    case SceneRow::mesh:
      break;
    case SceneRow::controls:
      for (int level = 0; level < levelCount(); ++level) {
        addLevel(level);
      }
      break;
    case SceneRow::level:
      addLevel(place.level);
      break;
    case SceneRow::group:
      addKind(place.level, place.kind);
      break;
    case SceneRow::point:
      points.push_back(set.levels[static_cast<std::size_t>(place.level)][place.point].id);
  }
  return points;
}

}  // namespace pbffd::ui
