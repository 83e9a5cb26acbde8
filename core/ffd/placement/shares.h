#pragma once

#include "core/ffd/placement/placement.h"
#include "core/ffd/placement/surface_parts.h"

namespace pbffd {

/// How many points go where.
struct Shares {
  Index interior = 0;  ///< inside the closed parts
  Index exterior = 0;  ///< outside them
  Index around = 0;    ///< on both sides of the open parts
};

/// By the area of closed and open parts, and by the exterior share within the closed ones.
Shares wantedShares(const PlacementOptions& options, const SurfaceParts& parts);

/// The wanted shares where each has room for so many; what one has no room for goes to the others.
Shares fittedShares(const Shares& wanted, Index interiorRoom, Index exteriorRoom, Index aroundRoom);

}  // namespace pbffd
