#pragma once

#include "core/ffd/placement/exterior_points.h"
#include "core/ffd/placement/interior_points.h"
#include "core/ffd/placement/placement.h"

#include <memory>

namespace pbffd {

/// The ground of a placement in pieces, each with the options that it was made for; all but the number of
/// points. Pieces are shared between caches.
class PlacementCache {
 public:
  /// What all pieces depend on.
  struct Ground {
    Surface surface;
    Index sites;   ///< 0: every vertex
    Index places;  ///< where exterior points may start
    unsigned seed;
    bool operator==(const Ground&) const = default;
  };

  std::shared_ptr<const RestMesh> mesh;
  Ground ground;
  double offset;
  std::shared_ptr<const SurfaceParts> parts;
  std::shared_ptr<const PointPool> interior;      ///< Voronoi vertices inside
  std::shared_ptr<const ExteriorPools> exterior;  ///< at `offset`

  /// What the points outside closed parts come down to for one number of them; made while Qhull runs.
  struct Outside {
    Index target = -1;  ///< -1: not made
    std::shared_ptr<const PointPool> points;
  };
  Outside outside;

  /// Uses of `before` what was made for the same mesh and options, and makes the rest. The Voronoi vertices
  /// and the exterior candidates are computed side by side. Throws Cancelled.
  static std::shared_ptr<const PlacementCache> make(const std::shared_ptr<const RestMesh>& mesh,
                                                    const PlacementOptions& options, const Progress& progress,
                                                    const PlacementCache* before);
};

/// placeControlPoints() for who places once: the result has no cache, which is let go as soon as it has served.
PlacementResult placeControlPointsOnce(const std::shared_ptr<const RestMesh>& mesh,
                                       const PlacementOptions& options, const Progress& progress = {});

}  // namespace pbffd
