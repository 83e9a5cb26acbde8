#pragma once

#include "core/ffd/placement/surface_parts.h"

#include <vector>

namespace pbffd {

/// Points of a surface with the normals that look out of it: Voronoi sites, and where exterior points start.
struct SurfaceSamples {
  Points positions{0, 3};
  Points normals{0, 3};
  std::vector<Index> parts;  ///< one a sample

  Index size() const { return static_cast<Index>(parts.size()); }
};

/// Every vertex that has a face.
SurfaceSamples everyVertex(const SurfaceParts& parts);

/// `count` vertices (all when there are no more), well spaced, closer together where the surface bends; on
/// both sides of a thin wall and on every part. `seed` chooses between the many such sets.
/// Throws Cancelled.
SurfaceSamples spacedVertices(const SurfaceParts& parts, Index count, unsigned seed,
                              const Progress& progress = {});

/// `samples` and so many points of the faces between them that there are `count`, well spaced: for meshes
/// of few vertices.
SurfaceSamples withFaceSamples(const SurfaceParts& parts, const SurfaceSamples& samples, Index count,
                               unsigned seed);

/// The samples of closed or of open parts.
SurfaceSamples samplesOf(const SurfaceParts& parts, const SurfaceSamples& samples, bool closed);

}  // namespace pbffd
