#include "resources/samples/generator/solid.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace pbffd::samples {
namespace {

/// How far two limbs that meet beside their root run into each other, as a share of the root's blend.
constexpr double limbBlend = 0.25;

/// A solid is evaluated too often to allocate memory for it each time.
constexpr std::size_t maxLimbs = 32;

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
  const double h = reach > 0.0 ? std::max(reach - std::abs(a - b), 0.0) / reach : 0.0;
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

Limb chain(std::string name, const std::vector<Section>& sections, double root, std::string parent) {
  constexpr int bonesASpan = 3;
  const auto count = static_cast<std::ptrdiff_t>(sections.size());
  const auto row = [&](std::ptrdiff_t i) {
    const Section& section = sections[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, count - 1))];
    return Eigen::Vector4d(section.center.x(), section.center.y(), section.center.z(), section.radius);
  };
  const auto at = [&](std::ptrdiff_t span, double t) -> Eigen::Vector4d {
    const Eigen::Vector4d a = row(span - 1);
    const Eigen::Vector4d b = row(span);
    const Eigen::Vector4d c = row(span + 1);
    const Eigen::Vector4d d = row(span + 2);
    return 0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t +
                  (3.0 * b - a - 3.0 * c + d) * t * t * t);
  };
  Limb limb{std::move(name), {}, 0.0, root, std::move(parent), true};
  for (std::ptrdiff_t span = 0; span + 1 < count; ++span) {
    for (int i = 0; i < bonesASpan; ++i) {
      const Eigen::Vector4d from = at(span, static_cast<double>(i) / bonesASpan);
      const Eigen::Vector4d to = at(span, static_cast<double>(i + 1) / bonesASpan);
      limb.bones.push_back({from.head<3>(), to.head<3>(), from.w(), to.w()});
    }
  }
  return limb;
}

double Bone::distance(const Vec3& point) const {
  if (flatness == 1.0) {
    return roundConeDistance(point - from, to - from, fromRadius, toRadius);
  }
  const Vec3 direction = flatDirection.normalized();
  const double stretch = 1.0 / flatness - 1.0;
  const auto unflattened = [&](const Vec3& v) { return Vec3(v + stretch * v.dot(direction) * direction); };
  return flatness * roundConeDistance(unflattened(point - from), unflattened(to - from), fromRadius, toRadius);
}

Solid::Solid(std::vector<Limb> limbs)
    : limbs_(std::move(limbs)), parentOf_(limbs_.size(), 0), isParent_(limbs_.size(), false) {
  if (limbs_.empty() || limbs_.size() > maxLimbs) {
    throw InvalidInput(format("A solid has 1 to {} limbs, not {}.", maxLimbs, limbs_.size()));
  }
  std::transform(limbs_.begin(), limbs_.end(), std::back_inserter(hulls_), hullOf);
  for (std::size_t l = 1; l < limbs_.size(); ++l) {
    const auto parent = std::find_if(limbs_.begin(), limbs_.begin() + static_cast<std::ptrdiff_t>(l),
                                     [&](const Limb& limb) { return limb.name == limbs_[l].parent; });
    parentOf_[l] = static_cast<std::size_t>(parent - limbs_.begin());
    if (parentOf_[l] == l) {
      throw InvalidInput(
          format("{} grows from {}, which does not come before it.", limbs_[l].name, limbs_[l].parent));
    }
    isParent_[parentOf_[l]] = true;
  }
}

Solid::Hull Solid::hullOf(const Limb& limb) {
  Hull hull{limb.bones.front().from, 0.0, 1.0};
  for (const Bone& bone : limb.bones) {
    const double length = (bone.to - bone.from).norm() / bone.flatness;
    const double radius = std::max(bone.fromRadius, bone.toRadius) + limb.joint;
    hull.radius = std::max(hull.radius, (bone.from - hull.center).norm() + length + radius);
    hull.flatness = std::min(hull.flatness, bone.flatness);
  }
  return hull;
}

double Solid::value(const Vec3& point) const {
  std::array<double, maxLimbs> alone;
  alone[0] = limbDistance(limbs_.front(), point);
  double distance = alone[0];
  for (std::size_t l = 1; l < limbs_.size(); ++l) {
    const double parent = alone[parentOf_[l]];
    if (!isParent_[l] && hulls_[l].leastDistance(point) > parent + limbs_[l].root) {
      distance = std::min(distance, parent);
      continue;
    }
    alone[l] = limbDistance(limbs_[l], point);
    const double joined = smoothMin(parent, alone[l], limbs_[l].root);
    // Where the limb is far there is nothing to blend, only the parent again.
    distance = smoothMin(distance, joined, std::min(limbBlend * limbs_[l].root, parent - joined));
  }
  if (isCut_) {
    distance = -smoothMin(-distance, point.y() - cutHeight_, cutRounding_);
  }
  return distance;
}

Vec3 Solid::gradient(const Vec3& point) const {
  // Differences towards the corners of a tetrahedron: two values fewer than along the axes.
  constexpr double step = 1e-4;
  Vec3 gradient = Vec3::Zero();
  for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}) {
    gradient += value(point + step * corner) * corner;
  }
  return gradient / (4.0 * step);
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
  for (std::string* name : {&other.name, &other.parent}) {
    if (const std::size_t at = name->find("left"); at != std::string::npos) {
      name->replace(at, 4, "right");
    }
  }
  for (Bone& bone : other.bones) {
    bone.from.z() = -bone.from.z();
    bone.to.z() = -bone.to.z();
    bone.flatDirection.z() = -bone.flatDirection.z();
  }
  return other;
}

}  // namespace pbffd::samples
