#include "ui/views/region_shape.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace pbffd::ui {
namespace {

/// Points of center + first cos t + second sin t.
std::vector<Vec3> ellipse(const Vec3& center, const Vec3& first, const Vec3& second, int count) {
  std::vector<Vec3> points;
  points.reserve(count);
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    points.push_back(center + std::cos(angle) * first + std::sin(angle) * second);
  }
  return points;
}

}  // namespace

std::array<std::vector<Vec3>, 3> regionRings(const Frame& frame, int count) {
  const auto ring = [&](int first, int second) {
    return ellipse(frame.center, frame.axes.col(first), frame.axes.col(second), count);
  };
  return {ring(0, 1), ring(1, 2), ring(2, 0)};
}

std::vector<Vec3> regionOutline(const Frame& frame, const Projection::Lens& lens, int count) {
  const Eigen::FullPivLU<Mat3> lu(frame.axes);
  if (!lu.isInvertible()) {
    return {};
  }
  // In the region's own space it is the unit sphere, and its border is the circle where rays touch.
  Vec3 middle = Vec3::Zero();
  double radius = 1.0;
  Vec3 towardsEye;
  if (lens.orthographic) {
    towardsEye = lu.solve(lens.toWorld.col(2)).normalized();
  } else {
    const Vec3 eye = lu.solve(lens.eye - frame.center);
    const double squared = eye.squaredNorm();
    if (squared <= 1.0) {
      return {};
    }
    middle = eye / squared;
    radius = std::sqrt(1.0 - 1.0 / squared);
    towardsEye = eye / std::sqrt(squared);
  }
  const Vec3 first = towardsEye.unitOrthogonal();
  const Vec3 second = towardsEye.cross(first);
  return ellipse(frame.center + frame.axes * middle, frame.axes * (radius * first),
                 frame.axes * (radius * second), count);
}

}  // namespace pbffd::ui
