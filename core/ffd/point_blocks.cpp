#include "core/ffd/point_blocks.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pbffd {
namespace {

constexpr Index fanOut = 8;
constexpr std::size_t grain = 256;

struct Extent {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
};

}  // namespace

PointBlocks::PointBlocks(const Points& points, const std::vector<Index>& order) {
  const std::size_t blocks = (order.size() + blockSize - 1) / blockSize;
  coordinates_.resize(48 * blocks);
  levels_.emplace_back(blocks);
  parallelFor(blocks, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      fillBlock(points, order, block);
    }
  });
  buildTree();
}

void PointBlocks::fillBlock(const Points& points, const std::vector<Index>& order, std::size_t block) {
  double* at = &coordinates_[48 * block];
  std::fill(at, at + 48, std::numeric_limits<double>::quiet_NaN());
  const std::size_t first = block * blockSize;
  const std::size_t count = std::min<std::size_t>(blockSize, order.size() - first);
  Extent extent;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 point = points.row(order[first + k]);
    for (int axis = 0; axis < 3; ++axis) {
      at[static_cast<std::size_t>(axis) * blockSize + k] = point[axis];
      extent.low[axis] = std::min(extent.low[axis], point[axis]);
      extent.high[axis] = std::max(extent.high[axis], point[axis]);
    }
  }
  // A little larger than the points, for the rounding of the centres, here and further up.
  const Vec3 slack =
      64.0 * std::numeric_limits<double>::epsilon() * extent.low.cwiseAbs().cwiseMax(extent.high.cwiseAbs());
  levels_[0][block] = {0.5 * (extent.low + extent.high), 0.5 * (extent.high - extent.low) + slack};
}

void PointBlocks::buildTree() {
  while (levels_.back().size() > 1) {
    const std::vector<Box>& below = levels_.back();
    std::vector<Box> above((below.size() + fanOut - 1) / fanOut);
    for (std::size_t i = 0; i < above.size(); ++i) {
      Extent extent;
      for (std::size_t k = i * fanOut; k < std::min(below.size(), (i + 1) * fanOut); ++k) {
        extent.low = extent.low.cwiseMin(below[k].center - below[k].half);
        extent.high = extent.high.cwiseMax(below[k].center + below[k].half);
      }
      above[i] = {0.5 * (extent.low + extent.high), 0.5 * (extent.high - extent.low)};
    }
    levels_.push_back(std::move(above));
  }
}

Lanes PointBlocks::squaredDistances(Index block, const Region& region) const {
  const double* x = &coordinates_[48 * static_cast<std::size_t>(block)];
  const double* y = x + blockSize;
  const double* z = y + blockSize;
  const Mat3& m = region.toLocal;
  const Vec3& center = region.center;
  Lanes squared;
  for (std::size_t k = 0; k < blockSize; ++k) {
    const double dx = x[k] - center.x();
    const double dy = y[k] - center.y();
    const double dz = z[k] - center.z();
    const double a = m(0, 0) * dx + m(0, 1) * dy + m(0, 2) * dz;
    const double b = m(1, 0) * dx + m(1, 1) * dy + m(1, 2) * dz;
    const double c = m(2, 0) * dx + m(2, 1) * dy + m(2, 2) * dz;
    squared[k] = a * a + b * b + c * c;
  }
  return squared;
}

bool PointBlocks::mayMeet(const Region& region, const Box& box) {
  // In the region's own frame: the nearest point of the box that encloses the turned box.
  const Vec3 center = region.parameter(box.center).cwiseAbs();
  const Vec3 half = region.toLocal.cwiseAbs() * box.half;
  return (center - half).cwiseMax(0.0).squaredNorm() < 1.0 + 1e-9;
}

void PointBlocks::collect(const Region& region, std::size_t level, Index box, std::vector<Index>& found) const {
  if (!mayMeet(region, levels_[level][static_cast<std::size_t>(box)])) {
    return;
  }
  if (level == 0) {
    found.push_back(box);
    return;
  }
  const Index end = std::min(static_cast<Index>(levels_[level - 1].size()), (box + 1) * fanOut);
  for (Index child = box * fanOut; child < end; ++child) {
    collect(region, level - 1, child, found);
  }
}

std::vector<Index> PointBlocks::blocksNear(const Region& region) const {
  std::vector<Index> found;
  if (!levels_.back().empty()) {
    collect(region, levels_.size() - 1, 0, found);
  }
  return found;
}

}  // namespace pbffd
