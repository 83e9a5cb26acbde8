#pragma once

#include "core/ffd/placement/point_pool.h"
#include "core/ffd/placement/surface_samples.h"

namespace pbffd {

/// What stands off the surface: the samples moved along their normals (McDonnell & Qin, Figure 2, steps 6
/// and 7; 3.2.3 for open parts).
struct ExteriorPools {
  PointPool outside;   ///< of closed parts, at +offset; those that end inside are rejected
  PointPool around;    ///< of open parts, at +offset and -offset; not inside a closed part
  PointPool enclosed;  ///< the rejected ones of those closed parts that lost all: they lie inside others
};

/// offset: in mesh units. Runs in parallel. Throws Cancelled.
ExteriorPools exteriorPools(const SurfaceParts& parts, const SurfaceSamples& samples, double offset,
                            const Progress& progress);

}  // namespace pbffd
