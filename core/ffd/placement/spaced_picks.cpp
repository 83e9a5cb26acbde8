#include "core/ffd/placement/spaced_picks.h"

#include <algorithm>
#include <cmath>

namespace pbffd {
namespace {

/// So that the grid stays small where the spacing is fine.
constexpr double cellsAlongAnAxis = 120.0;

}  // namespace

SpacedPicks::SpacedPicks(const Vec3& low, const Vec3& high, double spacing) : low_(low) {
  const Vec3 extent = high - low;
  const double cell = std::max({spacing, extent.maxCoeff() / cellsAlongAnAxis, 1e-300});
  inverseCell_ = 1.0 / cell;
  for (int axis = 0; axis < 3; ++axis) {
    counts_[axis] = static_cast<Index>(extent[axis] * inverseCell_) + 1;
  }
  first_.assign(static_cast<std::size_t>(counts_[0]) * counts_[1] * counts_[2], -1);
}

Index SpacedPicks::cellAlong(int axis, double coordinate) const {
  const double cell = (coordinate - low_[axis]) * inverseCell_;
  return std::clamp(static_cast<Index>(std::clamp(cell, 0.0, 1e6)), 0, counts_[axis] - 1);
}

bool SpacedPicks::pick(const Candidate& candidate) {
  Index from[3];
  Index to[3];
  Index own[3];
  for (int axis = 0; axis < 3; ++axis) {
    from[axis] = cellAlong(axis, candidate.position[axis] - candidate.spacing);
    to[axis] = cellAlong(axis, candidate.position[axis] + candidate.spacing);
    own[axis] = cellAlong(axis, candidate.position[axis]);
  }
  const auto cellAt = [&](Index x, Index y, Index z) {
    return (static_cast<std::size_t>(z) * counts_[1] + y) * counts_[0] + x;
  };
  for (Index z = from[2]; z <= to[2]; ++z) {
    for (Index y = from[1]; y <= to[1]; ++y) {
      for (Index x = from[0]; x <= to[0]; ++x) {
        for (Index i = first_[cellAt(x, y, z)]; i >= 0; i = next_[i]) {
          const Candidate& other = picks_[i];
          const double spacing = std::min(candidate.spacing, other.spacing);
          if (other.part == candidate.part && candidate.normal.dot(other.normal) >= 0.0 &&
              (other.position - candidate.position).squaredNorm() < spacing * spacing) {
            return false;
          }
        }
      }
    }
  }
  Index& head = first_[cellAt(own[0], own[1], own[2])];
  next_.push_back(head);
  head = size();
  picks_.push_back(candidate);
  return true;
}

}  // namespace pbffd
