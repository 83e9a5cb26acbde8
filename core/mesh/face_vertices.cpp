#include "core/mesh/face_vertices.h"

#include <algorithm>
#include <utility>

namespace pbffd {

std::vector<bool> hasFaceFlags(const Mesh& mesh) {
  std::vector<bool> hasFace(static_cast<std::size_t>(mesh.vertexCount()), false);
  for (const Index vertex : mesh.faces.vertices()) {
    hasFace[vertex] = true;
  }
  return hasFace;
}

FacePositions::FacePositions(const Mesh& mesh) : points_(&mesh.positions) {
  const std::vector<bool> hasFace = hasFaceFlags(mesh);
  const auto count = std::count(hasFace.begin(), hasFace.end(), true);
  if (count == mesh.positions.rows()) {
    return;
  }
  Points surface(count, 3);
  Index row = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (hasFace[v]) {
      surface.row(row++) = mesh.positions.row(v);
    }
  }
  own_ = std::make_unique<const Points>(std::move(surface));
  points_ = own_.get();
}

}  // namespace pbffd
