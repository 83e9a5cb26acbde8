#pragma once

#include "core/mesh/rest_mesh.h"

#include <vector>

namespace pbffd {

/// The connected parts of a mesh as placement takes them.
struct MeshParts {
  std::vector<Index> ofFace;    ///< one a face
  std::vector<bool> isClosed;   ///< one a part: without a border, and its faces agree on which side is out
  Index inconsistentCount = 0;  ///< parts that are not closed only because their faces do not agree
};

/// The components of the mesh. Those with a border are joined where vertices lie at the very same position: a
/// solid whose corners have a vertex for each face is closed.
MeshParts meshParts(const RestMesh& mesh);

}  // namespace pbffd
