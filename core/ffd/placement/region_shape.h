#pragma once

#include "core/ffd/placement/placement.h"

#include <vector>

namespace pbffd {

/// The region of each point (McDonnell & Qin, Figure 2, steps 4 and 9): a ball whose radius is `factor`
/// times the distance of the nearest other point, or an ellipsoid of the same volume, long where its
/// neighbours lie farther away and flat where they lie in a plane. `lone`: the distance that counts where
/// there is no other point. Runs in parallel.
std::vector<Frame> regionsOf(const Points& points, double factor, RegionShape shape, double lone);

}  // namespace pbffd
