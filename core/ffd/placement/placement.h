#pragma once

#include "core/base/progress.h"
#include "core/ffd/control_set.h"
#include "core/mesh/rest_mesh.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pbffd {

enum class Surface { automatic, closed, open };
enum class RegionShape { sphere, ellipsoid };

/// The options of `place` (contract, section 1), with the program's defaults.
struct PlacementOptions {
  int points = 200;  ///< at the finest level, the master not counted
  int levels = 3;
  Basis basis;
  double master = 0.01;
  MasterMode masterMode = MasterMode::constant;
  double radiusFactor = 2.0;   ///< radius / distance of the nearest neighbour
  double offset = 0.05;        ///< of the exterior points from the surface, as a share of the diagonal
  double exteriorShare = 0.5;  ///< of the points
  Surface surface = Surface::automatic;
  RegionShape regions = RegionShape::sphere;
  Reach reach = Reach::connected;
  /// How many Voronoi sites: none = as many as the program finds sensible, 0 = every vertex.
  std::optional<int> sites;
  unsigned seed = 0;

  bool operator==(const PlacementOptions&) const = default;
};

/// `--paper`: gaussian, the paper's master, radius factor 1.5, offset 0.1, reach all.
PlacementOptions paperOptions();

/// Throws InvalidInput that names the option, its value and what is allowed.
void requireValid(const PlacementOptions& options);

/// Throws InvalidInput for a mesh that no control points can be placed on: without faces, with coordinates
/// that are not finite, with all vertices on a line or in a point.
void requirePlaceable(const RestMesh& mesh);

/// What placement computes before the number of points matters (Voronoi vertices inside, exterior
/// candidates); kept by the caller so that another number of points costs little.
class PlacementCache;

struct PlacementResult {
  Master master;
  Level finest;          ///< identifiers 1, 2, ... in order; the caller renumbers
  bool asClosed = true;  ///< whether any component was taken as closed
  int wanted = 0;        ///< what was asked for; finest.size() may be less
  /// What the user should know, a sentence each: fewer points than asked for and why, how the surface was
  /// taken.
  std::vector<std::string> remarks;
  std::shared_ptr<const PlacementCache> cache;
};

/// Places control points in and around the mesh (McDonnell & Qin, 3.2.1 to 3.2.3): steps as mapped in
/// core/equations.md. `cache` of an earlier result on the same mesh is used where its options allow.
/// Throws InvalidInput for a mesh without faces, with coordinates that are not finite, with all vertices
/// on a line or in a point; Cancelled.
PlacementResult placeControlPoints(const std::shared_ptr<const RestMesh>& mesh, const PlacementOptions& options,
                                   const Progress& progress = {},
                                   const std::shared_ptr<const PlacementCache>& cache = nullptr);

/// The master of a set on this mesh: rest frame at the centre of the bounds, its semi-axes 1.2 times the
/// bounding radius, both of the vertices that have a face (of all where there is none).
Master makeMaster(const RestMesh& mesh, double value, MasterMode mode);

}  // namespace pbffd
