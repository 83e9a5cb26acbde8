#include "tests/quality/tasks.h"

#include "tests/support/shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pbffd::test {
namespace {

constexpr double length = 5.0;
constexpr double heldAtEachEnd = 0.6;
constexpr double freeLength = length - 2.0 * heldAtEachEnd;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

/// 0 where the bar is held, 1 where its far end is, growing evenly between.
double shareAlong(double x) {
  return std::clamp((x - heldAtEachEnd) / freeLength, 0.0, 1.0);
}

/// The middle line runs along x to the held border, around an arc of `angle` in the x-y plane as long as the
/// free part, and straight on: the cross section at x goes along rigidly.
AffineMap bend(double x, double angle) {
  const double share = shareAlong(x);
  const double radius = freeLength / angle;
  const double turned = share * angle;
  const Vec3 arc(heldAtEachEnd + radius * std::sin(turned), radius * (1.0 - std::cos(turned)), 0.0);
  const Vec3 from(heldAtEachEnd + share * freeLength, 0.0, 0.0);
  const Mat3 rotation = Eigen::AngleAxisd(turned, Vec3::UnitZ()).toRotationMatrix();
  return makeMap(rotation, arc - rotation * from);
}

Mesh squareBar(int rings, int perSide) {
  Mesh round = cylinder(length, 0.5, rings, 4 * perSide);
  // Each ring is walked along the square instead of the circle.
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < 4 * perSide; ++s) {
      const double along = -0.5 + static_cast<double>(s % perSide) / perSide;
      const Eigen::Vector2d side(along, -0.5);
      const Eigen::Rotation2Dd turn(s / perSide * std::numbers::pi / 2.0);
      round.positions.row(r * 4 * perSide + s).tail<2>() = (turn * side).transpose();
    }
  }
  return round;
}

}  // namespace

Task bendTask() {
  return {"bend 120", cylinder(length, 0.5, 129, 48),
          [](const Vec3& place) { return bend(place.x(), radians(120.0)); }};
}

Task twistTask() {
  return {"twist 135", squareBar(129, 12), [](const Vec3& place) {
            const double angle = shareAlong(place.x()) * radians(135.0);
            return makeMap(Eigen::AngleAxisd(angle, Vec3::UnitX()).toRotationMatrix(), Vec3::Zero());
          }};
}

Task cactusTask() {
  // The branch is a thinner tube of its own, sunk into the trunk at three quarters of its length.
  constexpr double branchAt = 3.6;
  Mesh branch = cylinder(1.6, 0.25, 40, 24);
  const Mat3 turn = Eigen::AngleAxisd(std::numbers::pi / 2.0, Vec3::UnitY()).toRotationMatrix();
  branch.positions = (branch.positions * turn.transpose()).rowwise() + Vec3(branchAt, 0.0, -0.3).transpose();
  return {"cactus 70", merged(cylinder(length, 0.5, 95, 40), branch), [](const Vec3& place) {
            const bool isBranch = Vec3(0, place.y(), place.z()).norm() > 0.55;
            return bend(isBranch ? branchAt : place.x(), radians(70.0));
          }};
}

Points naturalShape(const Task& task, const Points& points) {
  Points shape(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vec3 place = points.row(i);
    shape.row(i) = applyMap(task.motion(place), place);
  }
  return shape;
}

}  // namespace pbffd::test
