#pragma once

#include "core/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace pbffd {

/// Numbers the cells of a grid of 2^21 cells a side over a cube around `bounds` so that cells with near
/// numbers are near: the path from the root of an octree down to the cell, three bits a step.
class MortonCode {
 public:
  static constexpr int depth = 21;

  explicit MortonCode(const Bounds& bounds) : low_(bounds.low) {
    const double longest = (bounds.high - bounds.low).maxCoeff();
    scale_ = longest > 0.0 ? ((1 << depth) - 1) / longest : 0.0;
  }

  std::uint64_t operator()(const Vec3& point) const {
    const Vec3 cell = scale_ * (point - low_);
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      code |= spread(static_cast<std::uint64_t>(cell[axis])) << axis;
    }
    return code;
  }

 private:
  /// Spreads the low 21 bits so that two zeros follow each.
  static std::uint64_t spread(std::uint64_t x) {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    x = (x | x << 2) & 0x1249249249249249;
    return x;
  }

  Vec3 low_;
  double scale_;
};

/// The rows of the points by their codes, the lowest first where they are equal. Points outside the bounds
/// count as the nearest ones within.
std::vector<Index> mortonOrderOf(const Points& points, const Bounds& bounds);

}  // namespace pbffd
