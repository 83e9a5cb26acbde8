#pragma once

#include "app/yardsticks/triad.h"
#include "core/base/progress.h"
#include "core/ffd/placement/placement.h"
#include "core/mesh/rest_mesh.h"

#include <optional>

namespace pbffd::cli {

/// The weights of all points on every vertex, with one `reach`.
struct ParameterizeTimes {
  double seconds = 0.0;
  double bruteForce = 0.0;  ///< every vertex and every control point, a walk for each where `reach` asks for it
  double difference = 0.0;  ///< by how much a weight of the two differs at most
};

/// How long each step takes on one mesh, in seconds: medians of some runs (contract, section 1, `bench`).
struct Measurements {
  static constexpr Index many = 10000;

  Index vertices = 0;
  Index points = 0;
  double influences = 0.0;  ///< control points a vertex, the master not counted
  /// The Voronoi vertices of every vertex; none where the vertices lie in a plane, which has no such diagram.
  std::optional<double> qhull;
  double assemble = 0.0;           ///< placing the control points, with its own Voronoi diagram
  double assembleMany = 0.0;       ///< the same for `many` points
  Index manyPlaced = 0;            ///< as many of them found room
  Reach reach = Reach::connected;  ///< of the points placed
  ParameterizeTimes connected;
  ParameterizeTimes all;
  double deformAll = 0.0;  ///< new positions of all vertices after all points moved
  double deformOne = 0.0;  ///< the same after one moved
  double eigenEq7 = 0.0;   ///< V = WP + DA with sparse matrices, in double precision, on one thread
  Triad triad;

  /// With the reach of the points placed.
  const ParameterizeTimes& parameterize() const { return reach == Reach::all ? all : connected; }
  /// The bytes that a full pass must move, by its time, as a share of what the memory gives: rest and new
  /// positions (24 bytes a vertex) and 4 bytes an influence.
  double deformBandwidth() const;
  /// None without a Voronoi diagram.
  std::optional<double> timesQhull(double seconds) const;
};

/// Runs everything on the mesh. Throws like placeControlPoints(); Cancelled.
Measurements measure(const Mesh& mesh, const PlacementOptions& options, const Progress& progress);

}  // namespace pbffd::cli
