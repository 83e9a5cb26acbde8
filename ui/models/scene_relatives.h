#pragma once

#include "core/ffd/control_set.h"

#include <array>
#include <unordered_map>

namespace pbffd::ui {

class Selection;

/// What a point is to the selected ones: it stands for one of them, or one of them for it.
enum class Relation { none, parent, child };

/// The parents and children of the selection, on the levels beside the edit level.
class SceneRelatives {
 public:
  SceneRelatives() = default;
  SceneRelatives(const ControlSet& set, const Selection& selection);

  /// Of all points of a level (from 0): the next coarser one has parents only, the next finer one children.
  Relation onLevel(int level) const;
  Relation of(int level, PointId point) const;
  /// How many of a level are of this kind.
  int count(int level, PointKind kind) const;
  int count(int level) const;

 private:
  static constexpr std::size_t kindCount = 5;
  struct Side {
    int level = -1;
    std::unordered_map<PointId, PointKind> points;
    std::array<int, kindCount> counts{};
  };
  static Side sideOf(const ControlSet& set, int level, const std::vector<PointId>& points);
  const Side* at(int level) const;

  Side parents_;
  Side children_;
};

}  // namespace pbffd::ui
