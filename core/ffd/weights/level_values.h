#pragma once

#include "core/ffd/control_set.h"
#include "core/ffd/weights/point_blocks.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pbffd {

/// The basis values of a level's control points and of the master, made ready for many evaluations.
class LevelValues {
 public:
  LevelValues(const Basis& basis, const Master& master, const Level& level);
  LevelValues(LevelValues&&) noexcept = default;
  LevelValues(const LevelValues&) = delete;
  LevelValues& operator=(LevelValues&&) = delete;
  LevelValues& operator=(const LevelValues&) = delete;

  const Basis& basis() const { return basis_; }
  const Region& region(Index point) const { return regions_[static_cast<std::size_t>(point)]; }
  /// One a control point.
  const PointNumbers* numbers() const { return numbers_.data(); }
  /// Whether the master's value varies in space (McDonnell & Qin's master).
  bool hasMasterRegion() const { return hasMasterRegion_; }
  const Region& masterRegion() const { return masterRegion_; }

  /// The master's value at each point of a block; 0 beyond the last point in mode `paper`.
  Lanes master(const PointBlocks& blocks, Index block) const;

 private:
  Basis basis_;
  std::vector<Region> regions_;
  std::vector<PointNumbers> numbers_;  ///< they name what the regions hold
  bool hasMasterRegion_;
  double masterValue_;
  Region masterRegion_;
};

/// The control points that move any point of a block, ascending, and beside them the points that each moves:
/// bit k for the k-th point of the block.
struct BlockList {
  std::span<const Index> points;
  std::span<const std::uint16_t> members;
};

/// The list of a block among the lists of all: `start` has one more entry than there are blocks.
inline BlockList blockListOf(Index block, const std::vector<Index>& start, const std::vector<Index>& points,
                             const std::vector<std::uint16_t>& members) {
  const auto first = static_cast<std::size_t>(start[static_cast<std::size_t>(block)]);
  const auto count = static_cast<std::size_t>(start[static_cast<std::size_t>(block) + 1]) - first;
  return {{points.data() + first, count}, {members.data() + first, count}};
}

/// The basis values of one block at a time, and what makes weights of them (McDonnell & Qin, eq. (5)).
class BlockValues {
 public:
  BlockValues(const LevelValues& values, const PointBlocks& blocks) : values_(&values), blocks_(&blocks) {}

  void evaluate(Index block, const BlockList& list);

  /// The values of the list's entries at the 16 points; 0 at those that are no members.
  std::span<const Lanes> entries() const { return {entries_.data(), count_}; }
  const Lanes& master() const { return master_; }
  /// 1 over the sum of all values, taken in the order of the list and the master last; 0 where nothing
  /// reaches a point, which then stays.
  const Lanes& toWeight() const { return toWeight_; }

 private:
  const LevelValues* values_;
  const PointBlocks* blocks_;
  std::vector<Lanes> entries_{1};  ///< room for those of the longest list so far
  std::size_t count_ = 0;          ///< of those that belong to the list
  Lanes master_{};
  Lanes toWeight_{};
};

}  // namespace pbffd
