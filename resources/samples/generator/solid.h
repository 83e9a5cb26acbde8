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
  double flatness = 1.0;        ///< thickness along `flatDirection`, as a share of what it would be round
  Vec3 flatDirection{0, 0, 1};  ///< need not be at right angles to the bone

  /// The distance to the surface, negative inside (not exact where it is flattened).
  double distance(const Vec3& point) const;
};

/// Bones that run into each other smoothly, and grow smoothly out of another limb.
struct Limb {
  std::string name;
  std::vector<Bone> bones;
  double joint = 0.1;          ///< how far from a joint the blend of two bones reaches; 0: none
  double root = 0.1;           ///< the same where the limb meets the one that it grows from
  std::string parent{"body"};  ///< the limb that it grows from; comes before it
  bool isChain = false;        ///< each bone goes on where the last one ends
};

/// A place on the middle line of a limb, and how thick it is there.
struct Section {
  Vec3 center;
  double radius;
};

/// A limb whose middle line and thickness run smoothly through the sections, as a chain of short bones.
Limb chain(std::string name, const std::vector<Section>& sections, double root, std::string parent = "body");

/// Limbs that blend with what they grow from, and hardly with each other, so that near limbs stay apart.
class Solid {
 public:
  /// The first limb is what all others grow from in the end. Throws InvalidInput where a limb's parent does
  /// not come before it.
  explicit Solid(std::vector<Limb> limbs);

  /// Negative inside.
  double value(const Vec3& point) const;
  Vec3 gradient(const Vec3& point) const;

  /// Cuts off what lies below this plane, with an edge rounded by `rounding`.
  void standOn(double height, double rounding);

  const std::vector<Limb>& limbs() const { return limbs_; }
  /// The limb, and of that the bone, whose surface lies nearest.
  struct Place {
    Index limb;
    Index bone;
  };
  Place nearestBone(const Vec3& point) const;

 private:
  /// A ball around a limb, to see without its bones that a point is far from it.
  struct Hull {
    Vec3 center;
    double radius;
    double flatness;  ///< that of the flattest bone, by which distances are too small

    /// No more than the limb's distance.
    double leastDistance(const Vec3& point) const { return flatness * ((point - center).norm() - radius); }
  };
  static Hull hullOf(const Limb& limb);

  std::vector<Limb> limbs_;
  std::vector<Hull> hulls_;
  std::vector<std::size_t> parentOf_;
  std::vector<bool> isParent_;
  bool isCut_ = false;
  double cutHeight_ = 0.0;
  double cutRounding_ = 0.0;
};

/// The limb on the other side of the plane z = 0, with "left" in its names made "right".
Limb mirrored(const Limb& limb);

}  // namespace pbffd::samples
