#pragma once

#include "core/base/types.h"

#include <string>
#include <vector>

namespace pbffd::samples {

/// A limb's piece: two balls and the cone around them, flattened along one direction.
struct Bone {
  Vec3 from;
  Vec3 to;
  double fromRadius = 1.0;
  double toRadius = 1.0;
  double flatness = 1.0;         ///< thickness along `flatDirection`, as a share of what it would be round
  Vec3 flatDirection{0, 0, 1};   ///< need not be at right angles to the bone

  /// The distance to the surface, negative inside (not exact where it is flattened).
  double distance(const Vec3& point) const;
};

/// Bones that run into each other smoothly, and grow out of the body smoothly.
struct Limb {
  std::string name;
  std::vector<Bone> bones;
  double joint = 0.1;  ///< how far from a joint the blend of two bones reaches
  double root = 0.1;   ///< the same where the limb meets the body
};

/// A body with limbs: limbs blend with the body, hardly with each other, so that near limbs stay apart.
class Solid {
 public:
  Solid(Limb body, std::vector<Limb> limbs);

  /// Negative inside.
  double value(const Vec3& point) const;
  Vec3 gradient(const Vec3& point) const;

  /// Cuts off what lies below this plane, with an edge rounded by `rounding`.
  void standOn(double height, double rounding);

  /// The body is limb 0.
  const std::vector<Limb>& limbs() const { return limbs_; }
  /// The limb, and of that the bone, whose surface lies nearest.
  struct Place {
    Index limb;
    Index bone;
  };
  Place nearestBone(const Vec3& point) const;

 private:
  std::vector<Limb> limbs_;
  bool isCut_ = false;
  double cutHeight_ = 0.0;
  double cutRounding_ = 0.0;
};

/// The limb on the other side of the plane z = 0, with "left" in its name made "right".
Limb mirrored(const Limb& limb);

}  // namespace pbffd::samples
