#pragma once

#include "core/base/progress.h"
#include "core/ffd/placement/placement.h"
#include "core/mesh/rest_mesh.h"

#include <optional>

namespace pbffd::cli {

/// How long each step takes on one mesh, in seconds: medians of some runs (contract, section 1, `bench`).
struct Measurements {
  static constexpr Index many = 10000;

  Index vertices = 0;
  Index points = 0;
  double influences = 0.0;    ///< control points a vertex, the master not counted
  /// The Voronoi vertices of every vertex; none where the vertices lie in a plane, which has no such diagram.
  std::optional<double> qhull;
  double assemble = 0.0;      ///< placing the control points, with its own Voronoi diagram
  double assembleMany = 0.0;  ///< the same for `many` points
  double parameterize = 0.0;  ///< their weights on every vertex
  double bruteForce = 0.0;    ///< the values of every control point at every vertex, on the same threads
  double deformAll = 0.0;     ///< new positions of all vertices after all points moved
  double deformOne = 0.0;     ///< the same after one moved
  double eigenEq7 = 0.0;      ///< V = WP + DA with sparse matrices, in double precision, on one thread
  double triadBytesPerSecond = 0.0;

  /// The bytes that a full pass must move, by its time, as a share of what the memory gives: rest and new
  /// positions (24 bytes a vertex) and 4 bytes an influence.
  double deformBandwidth() const;
  /// None without a Voronoi diagram.
  std::optional<double> timesQhull(double seconds) const;
};

/// Runs everything on the mesh. Throws like placeControlPoints(); Cancelled.
Measurements measure(const Mesh& mesh, const PlacementOptions& options, const Progress& progress);

}  // namespace pbffd::cli
