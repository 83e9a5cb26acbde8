#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace pbffd {

/// How the faces of a mesh hang together; built with OpenMesh half-edges where they can hold the mesh.
struct Topology {
  Index components = 0;                 ///< connected by edges; isolated vertices do not count
  Index boundaryEdges = 0;              ///< edges of one face
  Index nonmanifoldEdges = 0;           ///< edges of more than two faces
  Index isolatedVertices = 0;           ///< vertices of no face
  bool isClosed = false;                ///< there are faces, and every edge has two
  std::vector<Index> componentOfFace;   ///< one a face
  std::vector<bool> isComponentClosed;  ///< one a component
};
Topology topologyOf(const Mesh& mesh);

}  // namespace pbffd
