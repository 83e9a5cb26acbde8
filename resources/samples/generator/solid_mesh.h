#pragma once

#include "resources/samples/generator/sample.h"
#include "resources/samples/generator/solid.h"

namespace pbffd::samples {

struct SolidMeshOptions {
  double edge = 0.05;       ///< about the length of the mesh's edges
  bool asTriangles = true;  ///< else quads
};

/// The surface of a solid as a mesh of even faces: a surface net over a grid, relaxed on the surface. Every
/// limb is a group; every bone is unrolled like a tin can into a tile of its own of the texture.
Sample meshOfSolid(const Solid& solid, const SolidMeshOptions& options);

}  // namespace pbffd::samples
