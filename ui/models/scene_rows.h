#pragma once

#include "core/ffd/control_set.h"
#include "ui/models/point_filter.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace pbffd::ui {

enum class SceneRow { mesh, controls, level, group, point };

/// What a row of the scene tree stands for.
struct ScenePlace {
  SceneRow row = SceneRow::mesh;
  int level = -1;  ///< from 0
  PointKind kind = PointKind::interior;
  Index point = -1;  ///< its place in the level
};

/// Which rows the scene tree has: for each level the kinds that occur, and for each kind the places of its
/// points, as far as the filter lets them through.
class SceneRows {
 public:
  static constexpr int kindCount = 5;

  SceneRows() = default;
  SceneRows(const ControlSet& set, const PointFilter& filter);

  int levelCount() const { return static_cast<int>(levels_.size()); }
  /// Groups of level `level` (from 0), in the order of the kinds.
  int groupCount(int level) const { return static_cast<int>(at(level).kinds.size()); }
  PointKind kindOfGroup(int level, int row) const { return at(level).kinds[static_cast<std::size_t>(row)]; }
  int rowOfGroup(int level, PointKind kind) const;
  const std::vector<Index>& places(int level, PointKind kind) const {
    return at(level).places[static_cast<std::size_t>(kind)];
  }

  /// Where a point is; -1 where the filter hides it or it is not of this level.
  struct Spot {
    PointKind kind = PointKind::interior;
    int row = -1;
  };
  Spot find(int level, PointId point) const;

  /// The points below a row (a point's own, all of a group, a level or the set).
  std::vector<PointId> pointsBelow(const ScenePlace& place, const ControlSet& set) const;

 private:
  struct LevelRows {
    std::vector<PointKind> kinds;
    std::array<std::vector<Index>, kindCount> places;
    std::unordered_map<PointId, Spot> spots;
  };
  const LevelRows& at(int level) const { return levels_[static_cast<std::size_t>(level)]; }

  std::vector<LevelRows> levels_;
};

}  // namespace pbffd::ui
