#pragma once

#include "core/ffd/control_set.h"
#include "core/ffd/placement/placement_cache.h"

#include <vector>

namespace pbffd {

/// What the refinement of a level needs to know of it.
struct RefinementTask {
  const Level& level;
  const std::vector<Index>& places;  ///< the points that are refined
  int factor;                        ///< so many points shall be where one is
};

/// The places that new points may take: what placement takes its own from.
struct RefinementPools {
  std::shared_ptr<const SurfaceParts> parts;
  PointPool inside;
  PointPool outside;  ///< of closed parts, and on both sides of open ones
};

/// The pools of a placement with these options. Where the regions to come are so small that points at the
/// usual offset would hardly reach the surface, the exterior points stand nearer to it. `cache` is brought up
/// to date. Throws Cancelled.
RefinementPools refinementPools(const std::shared_ptr<const RestMesh>& mesh, const RefinementTask& task,
                                const PlacementOptions& options, std::shared_ptr<const PlacementCache>& cache,
                                const Progress& progress);

/// Where the pool inside is too small for `placesForEach` times the points that will be there, as a medial axis
/// that is a line may be, adds points spread over the inside, as placement does. Throws Cancelled.
void spreadInside(RefinementPools& pools, const RefinementTask& task, int placesForEach, unsigned seed,
                  const Progress& progress);

/// The radius of the ball of the same volume.
double sizeOf(const Frame& region);

/// How large the region of a new point may be at most: its size / that of the region that it refines.
double greatestShare(int factor);

/// Where a new point stands.
struct RefinedPlace {
  Vec3 center;
  Index refines;  ///< the place in the level
};

/// factor - 1 places for each point that is refined: pool points of its kind that lie in its region, nearer to
/// it than to the others (measured by their regions), in sight of it, and near enough to a vertex; one after
/// the other the one that is farthest from all points so far. What one point has no room for goes to the
/// others; fewer come back where none has room. Throws Cancelled.
std::vector<RefinedPlace> refinedPlaces(const RefinementTask& task, const RefinementPools& pools,
                                        const RestMesh& mesh, const Progress& progress);

}  // namespace pbffd
