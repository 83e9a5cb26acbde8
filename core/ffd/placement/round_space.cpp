#include "core/ffd/placement/round_space.h"

#include "core/mesh/spread.h"

#include <algorithm>

namespace pbffd {

std::optional<RoundSpace> RoundSpace::of(const Points& positions, const Points& surface) {
  // Standard deviations whose least and greatest are farther apart are those of a stretched set.
  constexpr double greatestRatio = 100.0;
  const Spread spread = spreadAlongAxes(surface);
  const Vec3& deviations = spread.deviations;
  if (!(deviations[2] > greatestRatio * deviations[0])) {
    return std::nullopt;
  }
  // What is made of rounding stays flat, and nothing comes so far off that single precision would overflow.
  constexpr double leastShare = 1e-10;
  const double least = std::max(roundingShareOf(surface), leastShare) * deviations[2];
  RoundSpace space;
  space.center_ = spread.center;
  space.linear_ = deviations.cwiseMax(least).cwiseInverse().asDiagonal() * spread.axes.transpose();
  space.positions_ = std::make_unique<const Points>((positions.rowwise() - space.center_.transpose()) *
                                                    space.linear_.transpose());
  return space;
}

}  // namespace pbffd
