#include "resources/samples/generator/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pbffd::samples {
namespace {

/// How far two limbs that meet beside the body run into each other.
constexpr double limbBlend = 0.02;

/// The distance to two balls, the first of radius r1 about the origin, the second of radius r2 at `axis`,
/// and the cone that touches both.
double roundConeDistance(const Vec3& point, const Vec3& axis, double r1, double r2) {
  const double length2 = axis.squaredNorm();
  const double slope = r1 - r2;
  const double a2 = length2 - slope * slope;
  if (a2 <= 0.0) {  // one ball lies inside the other
    return r1 >= r2 ? point.norm() - r1 : (point - axis).norm() - r2;
  }
  const double along = point.dot(axis);
  const double beyond = along - length2;
  const double x2 = (point * length2 - axis * along).squaredNorm();
  const double y2 = along * along * length2;
  const double z2 = beyond * beyond * length2;
  const double k = std::copysign(slope * slope * x2, slope);
  if (std::copysign(a2 * z2, beyond) > k) {
    return std::sqrt(x2 + z2) / length2 - r2;
  }
  if (std::copysign(a2 * y2, along) < k) {
    return std::sqrt(x2 + y2) / length2 - r1;
  }
  return (std::sqrt(x2 * a2 / length2) + along * slope) / length2 - r1;
}

/// The lesser of the two, rounded off where they differ by less than `reach`.
double smoothMin(double a, double b, double reach) {
  const double h = std::max(reach - std::abs(a - b), 0.0) / reach;
  return std::min(a, b) - 0.25 * h * h * reach;
}

double limbDistance(const Limb& limb, const Vec3& point) {
  double distance = limb.bones.front().distance(point);
  for (std::size_t b = 1; b < limb.bones.size(); ++b) {
    distance = smoothMin(distance, limb.bones[b].distance(point), limb.joint);
  }
  return distance;
}

}  // namespace

double Bone::distance(const Vec3& point) const {
  const Vec3 direction = flatDirection.normalized();
  const double stretch = 1.0 / flatness - 1.0;
  const auto unflattened = [&](const Vec3& v) { return Vec3(v + stretch * v.dot(direction) * direction); };
  return flatness * roundConeDistance(unflattened(point - from), unflattened(to - from), fromRadius, toRadius);
}

Solid::Solid(Limb body, std::vector<Limb> limbs) : limbs_(std::move(limbs)) {
  limbs_.insert(limbs_.begin(), std::move(body));
}

double Solid::value(const Vec3& point) const {
  const double body = limbDistance(limbs_.front(), point);
  double distance = body;
  for (std::size_t l = 1; l < limbs_.size(); ++l) {
    const double joined = smoothMin(body, limbDistance(limbs_[l], point), limbs_[l].root);
    distance = smoothMin(distance, joined, std::min(limbBlend, limbs_[l].root));
  }
  if (isCut_) {
    distance = -smoothMin(-distance, point.y() - cutHeight_, cutRounding_);
  }
  return distance;
}

Vec3 Solid::gradient(const Vec3& point) const {
  const double step = 1e-4;
  Vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 offset = step * Vec3::Unit(axis);
    gradient[axis] = (value(point + offset) - value(point - offset)) / (2.0 * step);
  }
  return gradient;
}

void Solid::standOn(double height, double rounding) {
  isCut_ = true;
  cutHeight_ = height;
  cutRounding_ = rounding;
}

Solid::Place Solid::nearestBone(const Vec3& point) const {
  Place place{0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t l = 0; l < limbs_.size(); ++l) {
    for (std::size_t b = 0; b < limbs_[l].bones.size(); ++b) {
      const double distance = limbs_[l].bones[b].distance(point);
      if (distance < least) {
        least = distance;
        place = {static_cast<Index>(l), static_cast<Index>(b)};
      }
    }
  }
  return place;
}

Limb mirrored(const Limb& limb) {
  Limb other = limb;
  if (const std::size_t at = other.name.find("left"); at != std::string::npos) {
    other.name.replace(at, 4, "right");
  }
  for (Bone& bone : other.bones) {
    bone.from.z() = -bone.from.z();
    bone.to.z() = -bone.to.z();
    bone.flatDirection.z() = -bone.flatDirection.z();
  }
  return other;
}

}  // namespace pbffd::samples
