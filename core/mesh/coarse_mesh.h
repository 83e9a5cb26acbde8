#pragma once

#include "core/base/progress.h"
#include "core/mesh/rest_mesh.h"

#include <vector>

namespace pbffd {

/// A stand-in for a mesh: fewer triangles, between vertices of the mesh itself, so that it goes wherever the
/// mesh goes.
struct CoarseMesh {
  std::vector<Index> vertices;   ///< of the mesh, ascending
  std::vector<Index> triangles;  ///< 3 a triangle: places in `vertices`
};

/// At most `mostTriangles`, and not many fewer where the mesh allows it; all where it has no more. Vertices are
/// clustered by the cells of a grid (Rossignac and Borrel), but only as far as they hang together within their
/// cell: the two sides of a thin wall stay two, and so does an arm beside a body. Of each cluster the vertex
/// stays that is nearest to the planes of the triangles around. Where so much would vanish, in parts smaller
/// than the cells, all in a cell is one cluster. Triangles face as their vertices do. Throws Cancelled, soon
/// after it is asked for.
CoarseMesh coarseMesh(const RestMesh& mesh, Index mostTriangles, const Progress& progress = {});

}  // namespace pbffd
