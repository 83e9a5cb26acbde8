#pragma once

#include "core/mesh/mesh.h"
#include "resources/samples/generator/solid.h"

namespace pbffd::samples {

struct QuadMesh {
  Points positions{0, 3};
  Polygons faces;
};

/// The surface where solid.value() is 0, as quads of about `edge` in length: one vertex in each cell of a
/// grid that the surface passes through (a naive surface net), then evened out along the surface.
QuadMesh surfaceNet(const Solid& solid, double edge);

}  // namespace pbffd::samples
