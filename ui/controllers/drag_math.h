#pragma once

#include "core/base/types.h"
#include "ui/views/camera.h"

#include <optional>

namespace pbffd::ui {

/// A line through a point in a unit direction, or a plane through it with that normal.
struct Guide {
  Vec3 origin = Vec3::Zero();
  Vec3 direction = Vec3::UnitX();
};

/// How far along the line the ray passes nearest to it; none when they are nearly parallel.
std::optional<double> nearestOnLine(const PickRay& ray, const Guide& line);

/// Where the ray meets the plane in front of its origin; none when it does not, or nearly grazes it.
std::optional<Vec3> meetsPlane(const PickRay& ray, const Guide& plane);

/// The angle in radians, right-handed about the plane's normal, -pi to pi, from one point to another as
/// seen from the plane's origin. 0 when either is at the origin.
double angleBetween(const Guide& plane, const Vec3& from, const Vec3& to);

/// The nearest multiple of `step`; the value itself for a step of 0.
double snapped(double value, double step);

/// The step of moves: 1, 2 or 5 times a power of ten, near a hundredth of the size.
double moveStep(double size);

}  // namespace pbffd::ui
