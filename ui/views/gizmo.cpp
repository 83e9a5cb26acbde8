#include "ui/views/gizmo.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace pbffd::ui {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr int pointsOfRing = 96;
/// A plane square turned further than this from the view (cosine) is too thin to be hit.
constexpr double leastPlaneCosine = 0.15;

double distanceToSegment(const Vec2& point, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (point - from - share * along).norm();
}

bool isInQuad(const Vec2& point, const std::array<Vec2, 4>& corners) {
  int positive = 0;
  int negative = 0;
  for (int i = 0; i < 4; ++i) {
    const Vec2 edge = corners[(i + 1) % 4] - corners[i];
    const Vec2 to = point - corners[i];
    const double side = edge.x() * to.y() - edge.y() * to.x();
    positive += side >= 0.0 ? 1 : 0;
    negative += side <= 0.0 ? 1 : 0;
  }
  return positive == 4 || negative == 4;
}

}  // namespace

std::optional<int> axisOf(GizmoPart part) {
  switch (part) {
    case GizmoPart::axisX:
    case GizmoPart::planeX:
      return 0;
    case GizmoPart::axisY:
    case GizmoPart::planeY:
      return 1;
    case GizmoPart::axisZ:
    case GizmoPart::planeZ:
      return 2;
    default:
      return std::nullopt;
  }
}

bool isPlane(GizmoPart part) {
  return part == GizmoPart::planeX || part == GizmoPart::planeY || part == GizmoPart::planeZ;
}

GizmoShape::GizmoShape(const Gizmo& gizmo, const Projection& projection)
    : gizmo_(gizmo), projection_(projection), pixel_(projection.pixelSizeAt(gizmo.center)) {
  const Projection::Lens& lens = projection.lens();
  towardsEye_ = lens.orthographic ? Vec3(lens.toWorld.col(2)) : Vec3((lens.eye - gizmo.center).normalized());
}

Vec3 GizmoShape::axisEnd(int axis) const {
  return gizmo_.center + GizmoSizes::length * pixel_ * gizmo_.axes.col(axis);
}

bool GizmoShape::isAxisSeen(int axis) const {
  const Vec2 length = (projection_.toScreen(axisEnd(axis)) - projection_.toScreen(gizmo_.center)).head<2>();
  return length.norm() > GizmoSizes::leastAxis;
}

bool GizmoShape::isPlaneSeen(int normal) const {
  return std::abs(gizmo_.axes.col(normal).dot(towardsEye_)) > leastPlaneCosine;
}

std::array<Vec3, 4> GizmoShape::planeCorners(int normal) const {
  const Vec3 first = pixel_ * gizmo_.axes.col((normal + 1) % 3);
  const Vec3 second = pixel_ * gizmo_.axes.col((normal + 2) % 3);
  const double from = GizmoSizes::planeFrom;
  const double to = GizmoSizes::planeTo;
  const Vec3& c = gizmo_.center;
  return {c + from * first + from * second, c + to * first + from * second, c + to * first + to * second,
          c + from * first + to * second};
}

std::vector<Vec3> GizmoShape::ring(int axis) const {
  const bool isOuter = axis == 3;
  const Vec3 normal = isOuter ? towardsEye_ : Vec3(gizmo_.axes.col(axis));
  const double radius = (isOuter ? GizmoSizes::length : GizmoSizes::ring) * pixel_;
  const Vec3 first = isOuter ? normal.unitOrthogonal() : Vec3(gizmo_.axes.col((axis + 1) % 3));
  const Vec3 second = normal.cross(first);
  std::vector<Vec3> points;
  points.reserve(pointsOfRing);
  for (int i = 0; i < pointsOfRing; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / pointsOfRing;
    points.push_back(gizmo_.center + radius * (std::cos(angle) * first + std::sin(angle) * second));
  }
  return points;
}

bool GizmoShape::isInFront(const Vec3& point) const {
  return (point - gizmo_.center).dot(towardsEye_) > -1e-3 * GizmoSizes::ring * pixel_;
}

GizmoPart GizmoShape::partAt(double x, double y) const {
  if (gizmo_.kind == GizmoKind::none || projection_.isBehindEye(gizmo_.center)) {
    return GizmoPart::none;
  }
  return gizmo_.kind == GizmoKind::rotate ? partOfRings(x, y) : partOfAxes(x, y);
}

GizmoPart GizmoShape::partOfRings(double x, double y) const {
  const Vec2 at(x, y);
  double nearest = 0.5 * GizmoSizes::hitWidth;
  GizmoPart part = GizmoPart::none;
  const std::array<GizmoPart, 4> parts{GizmoPart::axisX, GizmoPart::axisY, GizmoPart::axisZ, GizmoPart::view};
  for (int axis = 0; axis < 4; ++axis) {
    const std::vector<Vec3> points = ring(axis);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3& next = points[(i + 1) % points.size()];
      if (axis < 3 && !isInFront(points[i])) {
        continue;
      }
      const double distance = distanceToSegment(at, projection_.toScreen(points[i]).head<2>(),
                                                projection_.toScreen(next).head<2>());
      if (distance < nearest) {
        nearest = distance;
        part = parts[axis];
      }
    }
  }
  const double fromCenter = (at - projection_.toScreen(gizmo_.center).head<2>()).norm();
  if (part == GizmoPart::none && fromCenter < GizmoSizes::ring) {
    part = GizmoPart::ball;
  }
  return part;
}

GizmoPart GizmoShape::partOfAxes(double x, double y) const {
  const Vec2 at(x, y);
  const Vec2 middle = projection_.toScreen(gizmo_.center).head<2>();
  if ((at - middle).norm() <= 0.5 * GizmoSizes::freeCenter + 2.0) {
    return GizmoPart::center;
  }
  double nearest = 0.5 * GizmoSizes::hitWidth;
  GizmoPart part = GizmoPart::none;
  const std::array<GizmoPart, 3> axes{GizmoPart::axisX, GizmoPart::axisY, GizmoPart::axisZ};
  for (int axis = 0; axis < 3; ++axis) {
    const double distance = distanceToSegment(at, middle, projection_.toScreen(axisEnd(axis)).head<2>());
    if (isAxisSeen(axis) && distance < nearest) {
      nearest = distance;
      part = axes[axis];
    }
  }
  if (part != GizmoPart::none || gizmo_.kind != GizmoKind::move) {
    return part;
  }
  const std::array<GizmoPart, 3> planes{GizmoPart::planeX, GizmoPart::planeY, GizmoPart::planeZ};
  for (int normal = 0; normal < 3; ++normal) {
    std::array<Vec2, 4> corners;
    const std::array<Vec3, 4> worldCorners = planeCorners(normal);
    for (int i = 0; i < 4; ++i) {
      corners[i] = projection_.toScreen(worldCorners[i]).head<2>();
    }
    if (isPlaneSeen(normal) && isInQuad(at, corners)) {
      return planes[normal];
    }
  }
  return GizmoPart::none;
}

}  // namespace pbffd::ui
