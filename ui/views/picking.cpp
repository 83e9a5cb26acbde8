#include "ui/views/picking.h"

#include "core/base/parallel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace pbffd::ui {
namespace {

/// Within this the cursor is on the point's disc, and the point in front is meant.
constexpr double discRadius = 5.0;
constexpr std::size_t trianglesOfRun = 8192;

struct Candidate {
  PointId id;
  double distance;
  double depth;
};

bool comesBefore(const Candidate& a, const Candidate& b) {
  const bool aOnDisc = a.distance <= discRadius;
  const bool bOnDisc = b.distance <= discRadius;
  const auto key = [](const Candidate& c, bool onDisc) {
    return std::tuple(!onDisc, onDisc ? c.depth : c.distance, c.id);
  };
  return key(a, aOnDisc) < key(b, bOnDisc);
}

bool isSeen(const Vec3& onScreen) {
  return onScreen.z() > -1.0;
}

Vec3 corner(const std::vector<float>& positions, Index vertex) {
  const float* at = positions.data() + 3 * static_cast<std::size_t>(vertex);
  return {at[0], at[1], at[2]};
}

/// Möller and Trumbore: the distance along the ray, or none.
std::optional<double> meets(const PickRay& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 first = b - a;
  const Vec3 second = c - a;
  const Vec3 across = ray.direction.cross(second);
  const double determinant = first.dot(across);
  if (determinant == 0.0) {
    return std::nullopt;
  }
  const Vec3 from = ray.origin - a;
  const double u = from.dot(across) / determinant;
  if (!(u >= 0.0 && u <= 1.0)) {
    return std::nullopt;
  }
  const Vec3 up = from.cross(first);
  const double v = ray.direction.dot(up) / determinant;
  const double distance = second.dot(up) / determinant;
  if (!(v >= 0.0 && u + v <= 1.0 && distance > 0.0)) {
    return std::nullopt;
  }
  return distance;
}

}  // namespace

std::vector<PointId> pickPoints(const std::vector<PickablePoint>& points, const Projection& projection,
                                const QPointF& at, double radius) {
  std::vector<Candidate> found;
  for (const PickablePoint& point : points) {
    const Vec3 seen = projection.toScreen(point.position);
    const double distance = std::hypot(seen.x() - at.x(), seen.y() - at.y());
    if (isSeen(seen) && distance <= radius) {
      found.push_back({point.id, distance, seen.z()});
    }
  }
  std::sort(found.begin(), found.end(), comesBefore);
  std::vector<PointId> ids;
  ids.reserve(found.size());
  for (const Candidate& candidate : found) {
    ids.push_back(candidate.id);
  }
  return ids;
}

std::vector<PointId> pickPointsIn(const std::vector<PickablePoint>& points, const Projection& projection,
                                  const QRectF& box) {
  const QRectF area = box.normalized();
  std::vector<PointId> ids;
  for (const PickablePoint& point : points) {
    const Vec3 seen = projection.toScreen(point.position);
    if (isSeen(seen) && seen.x() >= area.left() && seen.x() <= area.right() && seen.y() >= area.top() &&
        seen.y() <= area.bottom()) {
      ids.push_back(point.id);
    }
  }
  return ids;
}

std::optional<SurfacePick> pickSurface(const std::vector<float>& positions, const std::vector<Index>& triangles,
                                       const PickRay& ray) {
  const std::size_t count = triangles.size() / 3;
  const std::size_t runs = (count + trianglesOfRun - 1) / trianglesOfRun;
  std::vector<SurfacePick> nearest(runs, {0, std::numeric_limits<double>::infinity()});
  parallelFor(runs, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t run = begin; run < end; ++run) {
      for (std::size_t t = run * trianglesOfRun; t < std::min(count, (run + 1) * trianglesOfRun); ++t) {
        const auto distance =
            meets(ray, corner(positions, triangles[3 * t]), corner(positions, triangles[3 * t + 1]),
                  corner(positions, triangles[3 * t + 2]));
        if (distance && *distance < nearest[run].distance) {
          nearest[run] = {static_cast<Index>(t), *distance};
        }
      }
    }
  });
  const auto best = std::min_element(nearest.begin(), nearest.end(),
                                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
  if (best == nearest.end() || std::isinf(best->distance)) {
    return std::nullopt;
  }
  return *best;
}

}  // namespace pbffd::ui
