#pragma once

#include "core/ffd/basis.h"
#include "core/ffd/weights/large_array.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace pbffd {

/// Points in blocks of 16, taken in an order that keeps near what is near, with a tree of boxes over the
/// blocks: finds the few blocks that a region meets without looking at the others.
class PointBlocks {
 public:
  static constexpr Index blockSize = 16;

  /// order[slot] = row of `points`; block b holds slots [16 b, 16 b + 16). Keeps its own copy.
  PointBlocks(const Points& points, const std::vector<Index>& order);

  Index blockCount() const { return static_cast<Index>(coordinates_.size() / 48); }

  /// |u|^2 of each point of the block, the very bits of region.squaredDistance(); not a number in the places
  /// after the last point.
  Lanes squaredDistances(Index block, const Region& region) const;

  /// The block's 16 x, 16 y and 16 z, as the block kernels take them.
  const double* numbers(Index block) const { return &coordinates_[48 * static_cast<std::size_t>(block)]; }

  /// Bit k: whether the k-th point of the block is in the region.
  std::uint16_t inside(Index block, const Region& region) const;

  /// Point k of the block.
  Vec3 point(Index block, Index k) const {
    const double* at = numbers(block);
    return {at[k], at[blockSize + k], at[2 * blockSize + k]};
  }

  /// Bit k: whether the block has a k-th point; all but in the last block.
  std::uint16_t all(Index block) const { return block + 1 < blockCount() ? std::uint16_t{0xffff} : allOfLast_; }

  /// Calls visit(begin, end, isWhole) for the blocks [begin, end) that may have a point in the region,
  /// ascending: all that have one, and a few more. isWhole: inside() would say that all of their points are in
  /// the region.
  template <class Visit>
  void forEachNear(const Region& region, const Visit& visit) const {
    if (!levels_.back().empty()) {
      descend(region, levels_.size() - 1, 0, visit);
    }
  }
  /// Calls visit(block) for all blocks that may have a point at a squared distance less than limit() of a
  /// place; the nearer of eight first, so that a limit that shrinks meanwhile leaves few.
  template <class Limit, class Visit>
  void forEachWithin(const Vec3& place, const Limit& limit, const Visit& visit) const {
    if (!levels_.back().empty()) {
      approach(place, levels_.size() - 1, 0, limit, visit);
    }
  }
  /// The blocks of forEachNear().
  std::vector<Index> blocksNear(const Region& region) const;

 private:
  /// Eight boxes: 8 center x, y, z, 8 half x, y, z; a box of nothing is not a number and meets nothing.
  struct alignas(64) Boxes {
    std::array<double, 48> numbers;

    void set(std::size_t k, const Vec3& low, const Vec3& high);
    Vec3 low(std::size_t k) const;
    Vec3 high(std::size_t k) const;
  };

  template <class Visit>
  void descend(const Region& region, std::size_t level, Index boxes, const Visit& visit) const {
    const unsigned found =
        blockKernels().meets(levels_[level][static_cast<std::size_t>(boxes)].numbers.data(), region.numbers());
    for (unsigned left = found & 0xffU; left != 0; left &= left - 1) {
      const int k = std::countr_zero(left);
      const Index box = 8 * boxes + k;
      if ((found >> (8 + k) & 1U) != 0) {
        const std::int64_t end = std::int64_t{box + 1} << 3 * level;
        visit(box << 3 * level, static_cast<Index>(std::min<std::int64_t>(end, blockCount())), true);
      } else if (level == 0) {
        visit(box, box + 1, false);
      } else {
        descend(region, level - 1, box, visit);
      }
    }
  }
  template <class Limit, class Visit>
  void approach(const Vec3& place, std::size_t level, Index boxes, const Limit& limit,
                const Visit& visit) const {
    alignas(64) std::array<double, 8> gaps;
    const double* const numbers = levels_[level][static_cast<std::size_t>(boxes)].numbers.data();
    unsigned left = blockKernels().nearBoxes(numbers, place.data(), limit(), gaps.data());
    while (left != 0) {
      auto nearest = static_cast<std::size_t>(std::countr_zero(left));
      for (unsigned others = left & (left - 1); others != 0; others &= others - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(others));
        nearest = gaps[k] < gaps[nearest] ? k : nearest;
      }
      if (gaps[nearest] >= limit()) {
        return;
      }
      left &= ~(1U << nearest);
      const Index box = 8 * boxes + static_cast<Index>(nearest);
      if (level == 0) {
        visit(box);
      } else {
        approach(place, level - 1, box, limit, visit);
      }
    }
  }
  void fillBlock(const Points& points, const std::vector<Index>& order, std::size_t block);
  void buildTree();

  LargeArray<double> coordinates_;  ///< a block's 16 x, 16 y, 16 z
  std::uint16_t allOfLast_ = 0xffff;
  std::vector<std::vector<Boxes>> levels_;  ///< levels_[0]: the blocks' boxes; each next: those of eights below
};

}  // namespace pbffd
