#include "core/mesh/face_vertices.h"

#include <algorithm>

namespace pbffd {

std::vector<bool> hasFaceFlags(const Mesh& mesh) {
  std::vector<bool> hasFace(static_cast<std::size_t>(mesh.vertexCount()), false);
  for (const Index vertex : mesh.faces.vertices()) {
    hasFace[vertex] = true;
  }
  return hasFace;
}

Points positionsOfFaces(const Mesh& mesh) {
  const std::vector<bool> hasFace = hasFaceFlags(mesh);
  Points surface(std::count(hasFace.begin(), hasFace.end(), true), 3);
  Index row = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (hasFace[v]) {
      surface.row(row++) = mesh.positions.row(v);
    }
  }
  return surface;
}

}  // namespace pbffd
