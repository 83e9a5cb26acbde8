#include "core/ffd/weights/point_blocks.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <limits>

namespace pbffd {
namespace {

constexpr std::size_t eight = 8;
constexpr std::size_t grain = 256;
/// Rows strewn over memory are asked for so many turns before they are due.
constexpr std::size_t fetchedAhead = 48;

struct Extent {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());

  void add(const Vec3& lowOfOther, const Vec3& highOfOther) {
    // In this order, what is not a number is left out.
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], lowOfOther[axis]);
      high[axis] = std::max(high[axis], highOfOther[axis]);
    }
  }
};

}  // namespace

void PointBlocks::Boxes::set(std::size_t k, const Vec3& low, const Vec3& high) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    numbers[eight * axis + k] = 0.5 * (low[at] + high[at]);
    numbers[eight * (axis + 3) + k] = 0.5 * (high[at] - low[at]);
  }
}

Vec3 PointBlocks::Boxes::low(std::size_t k) const {
  return {numbers[k] - numbers[24 + k], numbers[8 + k] - numbers[32 + k], numbers[16 + k] - numbers[40 + k]};
}

Vec3 PointBlocks::Boxes::high(std::size_t k) const {
  return {numbers[k] + numbers[24 + k], numbers[8 + k] + numbers[32 + k], numbers[16 + k] + numbers[40 + k]};
}

PointBlocks::PointBlocks(const Points& points, const std::vector<Index>& order) {
  const std::size_t blocks = (order.size() + blockSize - 1) / blockSize;
  coordinates_.resize(48 * blocks);
  if (const std::size_t rest = order.size() % blockSize; rest != 0) {
    allOfLast_ = static_cast<std::uint16_t>((1U << rest) - 1);
  }
  levels_.emplace_back((blocks + eight - 1) / eight);
  for (Boxes& boxes : levels_[0]) {
    boxes.numbers.fill(std::numeric_limits<double>::quiet_NaN());
  }
  parallelFor(blocks, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      fillBlock(points, order, block);
    }
  });
  buildTree();
}

void PointBlocks::fillBlock(const Points& points, const std::vector<Index>& order, std::size_t block) {
  double* at = &coordinates_[48 * block];
  const std::size_t first = block * blockSize;
  const std::size_t count = std::min<std::size_t>(blockSize, order.size() - first);
  if (count < blockSize) {
    std::fill(at, at + 48, std::numeric_limits<double>::quiet_NaN());
  }
  Extent extent;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t ahead = std::min(first + k + fetchedAhead, order.size() - 1);
    __builtin_prefetch(points.data() + 3 * static_cast<std::ptrdiff_t>(order[ahead]));
    const Vec3 point = points.row(order[first + k]);
    at[k] = point.x();
    at[blockSize + k] = point.y();
    at[2 * blockSize + k] = point.z();
    extent.add(point, point);
  }
  // A little larger than the points, for the rounding of the centres, here and further up.
  const Vec3 slack =
      64.0 * std::numeric_limits<double>::epsilon() * extent.low.cwiseAbs().cwiseMax(extent.high.cwiseAbs());
  levels_[0][block / eight].set(block % eight, extent.low - slack, extent.high + slack);
}

void PointBlocks::buildTree() {
  while (levels_.back().size() > 1) {
    const std::vector<Boxes>& below = levels_.back();
    std::vector<Boxes> above((below.size() + eight - 1) / eight);
    for (Boxes& boxes : above) {
      boxes.numbers.fill(std::numeric_limits<double>::quiet_NaN());
    }
    for (std::size_t i = 0; i < below.size(); ++i) {
      Extent extent;
      for (std::size_t k = 0; k < eight; ++k) {
        extent.add(below[i].low(k), below[i].high(k));
      }
      above[i / eight].set(i % eight, extent.low, extent.high);
    }
    levels_.push_back(std::move(above));
  }
}

Lanes PointBlocks::squaredDistances(Index block, const Region& region) const {
  Lanes squared;
  blockKernels().squaredDistances(numbers(block), region.numbers(), squared.data());
  return squared;
}

std::uint16_t PointBlocks::inside(Index block, const Region& region) const {
  return static_cast<std::uint16_t>(blockKernels().inside(numbers(block), region.numbers()));
}

std::vector<Index> PointBlocks::blocksNear(const Region& region) const {
  std::vector<Index> found;
  forEachNear(region, [&](Index begin, Index end, bool) {
    for (Index block = begin; block < end; ++block) {
      found.push_back(block);
    }
  });
  return found;
}

}  // namespace pbffd
