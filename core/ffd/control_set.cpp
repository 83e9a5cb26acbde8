#include "core/ffd/control_set.h"

#include <algorithm>

namespace pbffd {

std::optional<Index> Level::find(PointId id) const {
  const auto at = std::find_if(points_.begin(), points_.end(), [id](const auto& p) { return p->id == id; });
  if (at == points_.end()) {
    return std::nullopt;
  }
  return static_cast<Index>(at - points_.begin());
}

bool Level::operator==(const Level& other) const {
  return std::equal(points_.begin(), points_.end(), other.points_.begin(), other.points_.end(),
                    [](const auto& a, const auto& b) { return a == b || *a == *b; });
}

LevelMaps mapsOf(const ControlSet& set, const Level& level) {
  LevelMaps maps;
  maps.points.reserve(static_cast<std::size_t>(level.size()));
  for (const ControlPoint& point : level) {
    maps.points.push_back(point.map());
  }
  maps.master = set.master.map();
  return maps;
}

}  // namespace pbffd
