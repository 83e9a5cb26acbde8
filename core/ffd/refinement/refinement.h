#pragma once

#include "core/ffd/placement/placement.h"

#include <memory>
#include <vector>

namespace pbffd {

/// How a level is refined.
struct RefinementOptions {
  PlacementOptions placement;  ///< whose point sets the new points are taken from
  int factor = 2;              ///< so many points for each that is refined, itself among them
};

/// A new point (without an identifier), and the place in its level of the one that it refines.
struct RefinedPoint {
  ControlPoint point;
  Index refines;
};

struct Refinement {
  std::vector<RefinedPoint> points;  ///< by the point that they refine, in the order these were given
  double change = 0.0;               ///< how far the vertex moves that they move most, in mesh units
  std::shared_ptr<const PlacementCache> cache;
};

/// More and smaller points for the regions of some (McDonnell & Qin's "refinement of the deformation space";
/// core/equations.md, Refinement). The points that are there stay as they are; `factor` - 1 new ones for each
/// of `places` stand in its region, at places that placement could have chosen, with smaller regions, and
/// follow the deformation that the finest level of `set` has: exactly where it is affine, and so that no vertex
/// moves by more than 0.5 % of the diagonal. Fewer come back where there is no room for more. `cache` as in
/// placeControlPoints(). Throws InvalidInput for a mesh that nothing can be placed on; Cancelled.
Refinement refinedPoints(const std::shared_ptr<const RestMesh>& mesh, const ControlSet& set,
                         const std::vector<Index>& places, const RefinementOptions& options,
                         const Progress& progress = {},
                         const std::shared_ptr<const PlacementCache>& cache = nullptr);

}  // namespace pbffd
