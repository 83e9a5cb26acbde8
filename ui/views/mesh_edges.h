#pragma once

#include "core/mesh/rest_mesh.h"

#include <vector>

namespace pbffd::ui {

/// The edges of a mesh's polygons (not those inside a polygon's triangulation), each once, as lines to draw.
struct MeshEdges {
  std::vector<Index> slots;        ///< 2 an edge, places in the mesh's Morton order
  std::vector<float> meanLengths;  ///< one a slot: of the edges that meet there, at rest; 0 without any
};
MeshEdges meshEdges(const RestMesh& mesh);

}  // namespace pbffd::ui
