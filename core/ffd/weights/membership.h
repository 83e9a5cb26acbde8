#pragma once

#include "core/ffd/weights/level_values.h"
#include "core/ffd/weights/point_blocks.h"

#include <cstdint>
#include <vector>

namespace pbffd {

/// The points that one control point moves: blocks in ascending order, and which of their 16 points.
struct Membership {
  std::vector<Index> blocks;
  std::vector<std::uint16_t> members;  ///< beside `blocks`: bit k for the k-th point; never 0
};

/// The points in the region.
Membership pointsInside(const PointBlocks& blocks, const Region& region);

/// The memberships of a level the other way about: for each block the control points that move any of its
/// points, ascending.
struct BlockLists {
  std::vector<Index> start;  ///< B + 1 entries
  std::vector<Index> points;
  std::vector<std::uint16_t> members;

  BlockList list(Index block) const { return blockListOf(block, start, points, members); }
};
BlockLists listsOf(const std::vector<Membership>& memberships, Index blockCount);

}  // namespace pbffd
