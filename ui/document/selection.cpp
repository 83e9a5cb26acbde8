#include "ui/document/selection.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace pbffd::ui {

const std::vector<PointId>& Selection::points() const {
  static const std::vector<PointId> none;
  const auto found = pointsOfLevel_.find(level_);
  return found == pointsOfLevel_.end() ? none : found->second;
}

bool Selection::contains(PointId point) const {
  const auto& all = points();
  return std::find(all.begin(), all.end(), point) != all.end();
}

PointId Selection::active() const {
  return isEmpty() ? 0 : points().back();
}

void Selection::setLevel(int level) {
  if (level == level_) {
    return;
  }
  level_ = level;
  Q_EMIT levelChanged(level);
  Q_EMIT changed();
}

void Selection::replace(std::vector<PointId> points) {
  if (points == this->points()) {
    return;
  }
  pointsOfLevel_[level_] = std::move(points);
  Q_EMIT changed();
}

void Selection::add(const std::vector<PointId>& points) {
  std::vector<PointId> all = this->points();
  std::unordered_set<PointId> known(all.begin(), all.end());
  std::copy_if(points.begin(), points.end(), std::back_inserter(all),
               [&](PointId point) { return known.insert(point).second; });
  replace(std::move(all));
}

void Selection::remove(const std::vector<PointId>& points) {
  const std::unordered_set<PointId> gone(points.begin(), points.end());
  std::vector<PointId> all = this->points();
  std::erase_if(all, [&](PointId point) { return gone.contains(point); });
  replace(std::move(all));
}

void Selection::toggle(PointId point) {
  if (contains(point)) {
    remove({point});
  } else {
    add({point});
  }
}

void Selection::clear() {
  replace({});
}

void Selection::keepOnly(const std::function<bool(int level, PointId point)>& existing) {
  bool lost = false;
  for (auto& [level, points] : pointsOfLevel_) {
    lost |= std::erase_if(points, [&, at = level](PointId point) { return !existing(at, point); }) > 0;
  }
  if (lost) {
    Q_EMIT changed();
  }
}

void Selection::renumberLevels(int by) {
  if (by == 0) {
    return;
  }
  std::map<int, std::vector<PointId>> renumbered;
  for (auto& [level, points] : pointsOfLevel_) {
    if (level + by >= 1) {
      renumbered[level + by] = std::move(points);
    }
  }
  pointsOfLevel_ = std::move(renumbered);
  level_ = std::max(level_ + by, 1);
  Q_EMIT levelsRenumbered(by);
  Q_EMIT levelChanged(level_);
  Q_EMIT changed();
}

void Selection::reset(int level) {
  pointsOfLevel_.clear();
  const bool moved = level_ != level;
  level_ = level;
  if (moved) {
    Q_EMIT levelChanged(level);
  }
  Q_EMIT changed();
}

}  // namespace pbffd::ui
