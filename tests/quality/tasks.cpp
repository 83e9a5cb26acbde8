#include "tests/quality/tasks.h"

#include "tests/quality/solids.h"
#include "tests/support/shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace pbffd::test {
namespace {

constexpr double length = 6.0;
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

/// 0 at the trunk, 1 at the branch, half and half where they are as near as each other. Space between and
/// around them belongs to the nearer.
double shareOfBranch(const CactusSize& size, const Vec3& place) {
  constexpr double seam = 0.6;  // how wide the one turns into the other
  if (place.y() <= 0.0) {
    return 0.0;
  }
  const double toTrunk = std::hypot(place.y(), place.z()) - size.radius;
  const double toBranch = std::hypot(place.x() - size.branchAt(), place.z()) - size.branchRadius;
  const double t = std::clamp(0.5 + (toTrunk - toBranch) / seam, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

Task bendTask() {
  return {"bend 120", cylinder(length, 0.5, 129, 48),
          [](const Vec3& place) { return bend(place.x(), radians(120.0)); }};
}

Task twistTask() {
  return {"twist 135", squareBar({.length = length, .width = 1.0, .across = 12, .along = 123}),
          [](const Vec3& place) {
            const double angle = shareAlong(place.x()) * radians(135.0);
            return makeMap(Eigen::AngleAxisd(angle, Vec3::UnitX()).toRotationMatrix(), Vec3::Zero());
          }};
}

Task cactusTask() {
  const CactusSize size{.length = length};
  return {"cactus 70", cactus(size), [size](const Vec3& place) {
            return bend(std::lerp(place.x(), size.branchAt(), shareOfBranch(size, place)), radians(70.0));
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

Points blendedShape(const Task& task, const Points& points) {
  const AffineMap first = task.motion(Vec3::Zero());
  const AffineMap last = task.motion(Vec3(length, 0.0, 0.0));
  Points shape(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Vec3 place = points.row(i);
    const double share = shareAlong(place.x());
    shape.row(i) = (1.0 - share) * applyMap(first, place) + share * applyMap(last, place);
  }
  return shape;
}

std::vector<Eigen::Index> handlesOf(const Points& points) {
  std::vector<Eigen::Index> handles;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double share = shareAlong(points(i, 0));
    if (share <= 0.0 || share >= 1.0) {
      handles.push_back(i);
    }
  }
  return handles;
}

}  // namespace pbffd::test
