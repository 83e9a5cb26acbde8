#pragma once

#include "core/mesh/mesh.h"

#include <vector>

namespace pbffd {

/// Whether each vertex has a face: the others are no part of the shape.
std::vector<bool> hasFaceFlags(const Mesh& mesh);

/// The positions of the vertices that have a face, in their order.
Points positionsOfFaces(const Mesh& mesh);

}  // namespace pbffd
