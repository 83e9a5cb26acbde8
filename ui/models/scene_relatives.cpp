#include "ui/models/scene_relatives.h"

#include "ui/document/hierarchy_links.h"
#include "ui/document/selection.h"

#include <unordered_set>

namespace pbffd::ui {

SceneRelatives::SceneRelatives(const ControlSet& set, const Selection& selection) {
  const int level = selection.level() - 1;
  if (selection.isEmpty()) {
    return;
  }
  parents_ = sideOf(set, level - 1, parentsOf(set, selection.level(), selection.points()));
  children_ = sideOf(set, level + 1, childrenOf(set, selection.level(), selection.points()));
}

SceneRelatives::Side SceneRelatives::sideOf(const ControlSet& set, int level,
                                            const std::vector<PointId>& points) {
  Side side;
  if (points.empty()) {
    return side;
  }
  side.level = level;
  const std::unordered_set<PointId> wanted(points.begin(), points.end());
  for (const ControlPoint& point : set.levels[static_cast<std::size_t>(level)]) {
    if (wanted.contains(point.id)) {
      side.points.emplace(point.id, point.kind);
      ++side.counts[static_cast<std::size_t>(point.kind)];
    }
  }
  return side;
}

const SceneRelatives::Side* SceneRelatives::at(int level) const {
  return level < 0                  ? nullptr
         : level == parents_.level  ? &parents_
         : level == children_.level ? &children_
                                    : nullptr;
}

Relation SceneRelatives::onLevel(int level) const {
  const Side* side = at(level);
  return side == nullptr ? Relation::none : side == &parents_ ? Relation::parent : Relation::child;
}

Relation SceneRelatives::of(int level, PointId point) const {
  const Side* side = at(level);
  return side != nullptr && side->points.contains(point) ? onLevel(level) : Relation::none;
}

int SceneRelatives::count(int level, PointKind kind) const {
  const Side* side = at(level);
  return side == nullptr ? 0 : side->counts[static_cast<std::size_t>(kind)];
}

int SceneRelatives::count(int level) const {
  const Side* side = at(level);
  return side == nullptr ? 0 : static_cast<int>(side->points.size());
}

}  // namespace pbffd::ui
