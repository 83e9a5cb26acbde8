#include "ui/views/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace pbffd::ui {
namespace {

constexpr double rightAngle = std::numbers::pi / 2;
constexpr double defaultFieldOfView = 35.0 * std::numbers::pi / 180.0;
/// The depth buffer resolves the far end poorly when the near plane is nearer than this share of it.
constexpr double nearestShare = 1e-3;
/// Ground this much nearer than the mesh is still drawn.
constexpr double groundShare = 0.25;

}  // namespace

Projection::Projection(const Lens& lens, double width, double height)
    : lens_(lens), width_(std::max(width, 1.0)), height_(std::max(height, 1.0)) {}

Vec3 Projection::toScreen(const Vec3& world) const {
  const Vec3 seen = lens_.toWorld.transpose() * (world - lens_.eye);
  const double depth = -seen.z();
  const double share = (depth - lens_.nearDepth) / (lens_.farDepth - lens_.nearDepth);
  double scale = 0.5 * height_ / lens_.halfHeight;
  if (!lens_.orthographic) {
    if (depth <= 0.0) {
      return {0.0, 0.0, -2.0};
    }
    scale /= depth;
  }
  return {0.5 * width_ + scale * seen.x(), 0.5 * height_ - scale * seen.y(), share};
}

PickRay Projection::rayThrough(double x, double y) const {
  const double unit = 2.0 * lens_.halfHeight / height_;
  const Vec3 across(unit * (x - 0.5 * width_), unit * (0.5 * height_ - y), 0.0);
  if (lens_.orthographic) {
    return {lens_.eye + lens_.toWorld * across, -lens_.toWorld.col(2)};
  }
  return {lens_.eye, (lens_.toWorld * (across - Vec3::UnitZ())).normalized()};
}

double Projection::pixelSizeAt(const Vec3& world) const {
  const double unit = 2.0 * lens_.halfHeight / height_;
  if (lens_.orthographic) {
    return unit;
  }
  const double depth = -lens_.toWorld.col(2).dot(world - lens_.eye);
  return unit * std::max(depth, lens_.nearDepth);
}

bool Projection::isBehindEye(const Vec3& world) const {
  return !lens_.orthographic && lens_.toWorld.col(2).dot(world - lens_.eye) >= 0.0;
}

Camera::Camera() : fieldOfView(defaultFieldOfView) {}

Mat3 Camera::axes() const {
  const double cy = std::cos(yaw);
  const double sy = std::sin(yaw);
  const double cp = std::cos(pitch);
  const double sp = std::sin(pitch);
  Mat3 axes;
  axes.col(0) = Vec3(cy, 0.0, -sy);
  axes.col(1) = Vec3(-sy * sp, cp, -cy * sp);
  axes.col(2) = Vec3(sy * cp, sp, cy * cp);
  return axes;
}

Vec3 Camera::eye() const {
  return focus + distance * axes().col(2);
}

void Camera::orbit(const Vec3& pivot, double yawBy, double pitchBy) {
  const Vec3 seen = axes().transpose() * (pivot - focus);
  yaw = std::remainder(yaw + yawBy, 2.0 * std::numbers::pi);
  pitch = std::clamp(pitch + pitchBy, -rightAngle, rightAngle);
  focus = pivot - axes() * seen;
}

void Camera::zoom(const Vec3& pivot, double factor) {
  focus = pivot + factor * (focus - pivot);
  distance *= factor;
}

void Camera::turnTo(double newYaw, double newPitch) {
  yaw = std::remainder(newYaw, 2.0 * std::numbers::pi);
  pitch = std::clamp(newPitch, -rightAngle, rightAngle);
}

void Camera::frame(const Vec3& center, const EachPoint& points, double aspect, double fill) {
  const Mat3 toSeen = axes().transpose();
  const double tall = fill * std::tan(0.5 * fieldOfView);
  const double wide = tall * aspect;
  double needed = 0.0;
  points([&](const Vec3& point) {
    const Vec3 seen = toSeen * (point - center);
    const double across = std::max(std::abs(seen.x()) / wide, std::abs(seen.y()) / tall);
    needed = std::max(needed, across + (orthographic ? 0.0 : seen.z()));
  });
  focus = center;
  distance = needed > 0.0 ? needed : 1.0;
}

Projection Camera::projection(double width, double height, const Extent& extent) const {
  Projection::Lens lens;
  lens.toWorld = axes();
  lens.orthographic = orthographic;
  const double slope = std::tan(0.5 * fieldOfView);
  lens.halfHeight = orthographic ? distance * slope : slope;
  lens.eye = eye();
  const double depth = -lens.toWorld.col(2).dot(extent.center - lens.eye);
  const double reach = std::max({extent.radius, extent.groundRadius, 1e-9 * distance});
  lens.farDepth = depth + reach;
  lens.nearDepth = depth - reach;
  if (!orthographic) {
    lens.farDepth = std::max(lens.farDepth, 1e-3 * distance);
    lens.nearDepth = std::max(groundShare * (depth - extent.radius), nearestShare * lens.farDepth);
  }
  return Projection(lens, width, height);
}

}  // namespace pbffd::ui
