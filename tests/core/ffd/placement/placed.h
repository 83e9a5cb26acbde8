#pragma once

#include "core/ffd/placement/placement.h"
#include "core/ffd/weights/parameterization.h"
#include "core/mesh/nearest.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace pbffd::test {

inline std::shared_ptr<const RestMesh> rest(Mesh mesh) {
  return std::make_shared<const RestMesh>(std::move(mesh));
}

inline PlacementOptions withPoints(int points) {
  PlacementOptions options;
  options.points = points;
  return options;
}

inline PlacementResult place(Mesh mesh, const PlacementOptions& options) {
  return placeControlPoints(rest(std::move(mesh)), options);
}

/// How many vertices of faces no point reaches, and how many points reach none.
struct Gaps {
  int uncovered = 0;
  int idle = 0;
};
inline Gaps gapsOf(const RestMesh& mesh, const Level& level) {
  std::vector<bool> isReached(static_cast<std::size_t>(mesh.vertexCount()), false);
  Gaps gaps;
  for (const ControlPoint& point : level) {
    const Reached reached = reachedVertices(mesh, point);
    gaps.idle += reached.vertices.empty();
    for (const Index vertex : reached.vertices) {
      isReached[static_cast<std::size_t>(vertex)] = true;
    }
  }
  gaps.uncovered = static_cast<int>(std::count(isReached.begin(), isReached.end(), false));
  return gaps;
}

/// Between any two of some points.
inline double leastDistance(const Points& points) {
  const NearestPoints nearest(points);
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < points.rows(); ++i) {
    least = std::min(least, nearest.nearest(points.row(i).transpose(), 2).back().distance);
  }
  return least;
}

inline Mesh stretched(Mesh mesh, const Vec3& factors) {
  mesh.positions = mesh.positions * factors.asDiagonal();
  return mesh;
}

}  // namespace pbffd::test
