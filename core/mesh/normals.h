#pragma once

#include "core/mesh/mesh.h"

namespace pbffd {

/// N x 3 unit normals of the vertices: the sum of the normals of the faces around, weighted by area.
/// Zero where a vertex has no face of any area.
Points vertexNormals(const Points& positions, const Triangles& triangles);

}  // namespace pbffd
