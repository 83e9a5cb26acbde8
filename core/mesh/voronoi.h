#pragma once

#include "core/base/progress.h"
#include "core/base/types.h"

#include <span>
#include <vector>

namespace pbffd {

/// The vertices of a Voronoi diagram: each is as far from its sites as from no other site.
struct VoronoiVertices {
  Points positions{0, 3};
  std::vector<double> radii;       ///< the distance to its sites, one a vertex
  std::vector<Index> siteStart;    ///< V + 1 entries
  std::vector<Index> siteIndices;  ///< rows of the sites, those of vertex v from siteStart[v] on, ascending

  Index size() const { return static_cast<Index>(radii.size()); }
  /// Four sites, or more that lie on one sphere.
  std::span<const Index> sites(Index vertex) const {
    return {siteIndices.data() + siteStart[vertex], siteIndices.data() + siteStart[vertex + 1]};
  }
};

/// The finite Voronoi vertices of the sites (McDonnell & Qin, Figure 2, step 1), by Qhull. The sites are
/// centred and scaled first; of sites at the same position the lowest row counts.
/// Throws InvalidInput for coordinates that are not finite and for coplanar sites; SolverError where Qhull
/// gives up; Cancelled within a fraction of a second.
VoronoiVertices voronoiVertices(const Points& sites, const Progress& progress = {});

}  // namespace pbffd
