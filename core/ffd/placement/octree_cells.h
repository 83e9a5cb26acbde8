#pragma once

#include "core/base/types.h"

#include <vector>

namespace pbffd {

/// Points sorted into the leaves of an octree.
struct OctreeCells {
  std::vector<Index> order;  ///< all points, cell after cell
  std::vector<Index> start;  ///< C + 1 entries: cell c holds order[start[c]] to order[start[c + 1] - 1]
};

/// Splits space until no leaf has more than `capacity` points (or all of them lie within 2^-21 of the
/// extent). Each group has an octree of its own; `groups` may be empty.
OctreeCells octreeCells(const Points& points, const std::vector<Index>& groups, Index capacity = 128);

}  // namespace pbffd
