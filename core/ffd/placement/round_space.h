#pragma once

#include "core/base/types.h"

#include <memory>
#include <optional>

namespace pbffd {

/// A space in which a wildly stretched surface is about as wide as it is long. What lies inside or between is
/// the same under every affine map, but single precision cannot tell the sides of a needle that is a million
/// times longer than wide.
class RoundSpace {
 public:
  /// surface: those of the positions that matter. None where they are not stretched so much that it would.
  static std::optional<RoundSpace> of(const Points& positions, const Points& surface);

  Vec3 operator()(const Vec3& point) const { return linear_ * (point - center_); }
  /// All positions there. Moving the space leaves them where they are in memory.
  const Points& positions() const { return *positions_; }

 private:
  Vec3 center_;
  Mat3 linear_;  ///< of positive determinant
  std::unique_ptr<const Points> positions_;
};

}  // namespace pbffd
