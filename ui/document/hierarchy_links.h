#pragma once

#include "core/ffd/control_set.h"

#include <vector>

namespace pbffd::ui {

/// A merged point and one of those that it stands for.
struct HierarchyLink {
  Index level = 0;   ///< of the merged point, as a place in ControlSet::levels
  Index parent = 0;  ///< its place in that level
  Index child = 0;   ///< the other's place in the next finer level

  bool operator==(const HierarchyLink&) const = default;
};

/// Every link of the set, coarsest first.
std::vector<HierarchyLink> hierarchyLinks(const ControlSet& set);

/// The branches through points of `level` (1 is the coarsest): what they stand for down to the finest level,
/// and what stands for them up to the coarsest.
std::vector<HierarchyLink> hierarchyLinks(const ControlSet& set, int level, const std::vector<PointId>& points);

/// The points of the next finer level that these points of `level` stand for, in the order of the parents.
std::vector<PointId> childrenOf(const ControlSet& set, int level, const std::vector<PointId>& points);

/// The points of the next coarser level that stand for these points of `level`, each once.
std::vector<PointId> parentsOf(const ControlSet& set, int level, const std::vector<PointId>& points);

}  // namespace pbffd::ui
