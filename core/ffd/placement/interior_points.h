#pragma once

#include "core/ffd/placement/point_pool.h"
#include "core/ffd/placement/surface_samples.h"
#include "core/mesh/voronoi.h"

namespace pbffd {

/// The Voronoi vertices of the sites that lie inside the closed parts: the approximate medial axis
/// (McDonnell & Qin, Figure 2, steps 1 and 2). Those of slivers, which hug the surface where there is volume
/// farther in, are left out. Empty where the sites have no Voronoi vertices. Throws Cancelled.
PointPool voronoiPointsInside(const SurfaceParts& parts, const SurfaceSamples& sites, const Progress& progress);

/// Whether each of some Voronoi vertices of sites on the closed parts is inside them: by the winding number,
/// but mostly by the votes of the sites' normals where these can be trusted: at least 99.9 % agree with the
/// winding number. rows: of the vertices. Throws Cancelled.
std::vector<bool> insideFlags(const std::vector<Index>& rows, const SurfaceParts& parts,
                              const SurfaceSamples& sites, const VoronoiVertices& vertices,
                              const Progress& progress);

}  // namespace pbffd
