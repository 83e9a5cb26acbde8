#include "ui/controllers/drag_math.h"

#include "ui/views/round_numbers.h"

#include <Eigen/Geometry>
#include <cmath>

namespace pbffd::ui {
namespace {

/// The sine of the angle between a ray and a line, or the cosine to a plane's normal, below which a pixel
/// stands for too much of the world.
constexpr double leastSlope = 0.02;
constexpr double stepShare = 0.01;

}  // namespace

std::optional<double> nearestOnLine(const PickRay& ray, const Guide& line) {
  const double cosine = ray.direction.dot(line.direction);
  const double sineSquared = 1.0 - cosine * cosine;
  if (sineSquared < leastSlope * leastSlope) {
    return std::nullopt;
  }
  const Vec3 between = ray.origin - line.origin;
  return (between.dot(line.direction) - cosine * between.dot(ray.direction)) / sineSquared;
}

std::optional<Vec3> meetsPlane(const PickRay& ray, const Guide& plane) {
  const double slope = ray.direction.dot(plane.direction);
  if (std::abs(slope) < leastSlope) {
    return std::nullopt;
  }
  const double distance = (plane.origin - ray.origin).dot(plane.direction) / slope;
  if (distance <= 0.0) {
    return std::nullopt;
  }
  return Vec3(ray.origin + distance * ray.direction);
}

double angleBetween(const Guide& plane, const Vec3& from, const Vec3& to) {
  const Vec3 first = from - plane.origin;
  const Vec3 second = to - plane.origin;
  const double across = plane.direction.dot(first.cross(second));
  const double along = first.dot(second) - first.dot(plane.direction) * second.dot(plane.direction);
  return across == 0.0 && along == 0.0 ? 0.0 : std::atan2(across, along);
}

double snapped(double value, double step) {
  return step > 0.0 ? std::round(value / step) * step : value;
}

double moveStep(double size) {
  return roundedDown125(stepShare * size);
}

}  // namespace pbffd::ui
