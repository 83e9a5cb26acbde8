#include "core/ffd/placement/spaced_picks.h"

#include <algorithm>
#include <cmath>

namespace pbffd {
namespace {

/// Cells are found by hashing, so that a part far away makes those of the others no larger.
constexpr std::uint64_t buckets = 1U << 17;
constexpr double cellsAlongAnAxis = 1e9;

std::size_t bucketOf(std::int64_t x, std::int64_t y, std::int64_t z) {
  const auto mixed = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15U ^
                     static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fU ^
                     static_cast<std::uint64_t>(z) * 0x165667b19e3779f9U;
  return (mixed ^ mixed >> 29U ^ mixed >> 47U) & (buckets - 1);
}

}  // namespace

SpacedPicks::SpacedPicks(const Vec3& low, const Vec3& high, double spacing) : low_(low) {
  const Vec3 extent = high - low;
  const double cell = std::max({spacing, extent.maxCoeff() / cellsAlongAnAxis, 1e-300});
  inverseCell_ = 1.0 / cell;
  first_.assign(buckets, -1);
}

std::int64_t SpacedPicks::cellAlong(int axis, double coordinate) const {
  const double cell = (coordinate - low_[axis]) * inverseCell_;
  return static_cast<std::int64_t>(std::clamp(cell, 0.0, 2.0 * cellsAlongAnAxis));
}

std::vector<Vec3> SpacedPicks::positions() const {
  std::vector<Vec3> positions;
  positions.reserve(picks_.size());
  for (const Candidate& pick : picks_) {
    positions.push_back(pick.position);
  }
  return positions;
}

bool SpacedPicks::pick(const Candidate& candidate) {
  std::int64_t from[3];
  std::int64_t to[3];
  std::int64_t own[3];
  for (int axis = 0; axis < 3; ++axis) {
    from[axis] = cellAlong(axis, candidate.position[axis] - candidate.spacing);
    to[axis] = cellAlong(axis, candidate.position[axis] + candidate.spacing);
    own[axis] = cellAlong(axis, candidate.position[axis]);
  }
  for (std::int64_t z = from[2]; z <= to[2]; ++z) {
    for (std::int64_t y = from[1]; y <= to[1]; ++y) {
      for (std::int64_t x = from[0]; x <= to[0]; ++x) {
        for (Index i = first_[bucketOf(x, y, z)]; i >= 0; i = next_[i]) {
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
  Index& head = first_[bucketOf(own[0], own[1], own[2])];
  next_.push_back(head);
  head = size();
  picks_.push_back(candidate);
  return true;
}

}  // namespace pbffd
