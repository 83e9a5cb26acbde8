#pragma once

#include "core/mesh/face_vertices.h"
#include "core/mesh/rest_mesh.h"

#include <optional>

namespace pbffd {

/// Finds the nearest vertex that has a face. Where every vertex has one, by the mesh's own search. The mesh
/// lives as long.
class NearestFaceVertex {
 public:
  explicit NearestFaceVertex(const RestMesh& mesh);
  NearestFaceVertex(const NearestFaceVertex&) = delete;
  NearestFaceVertex& operator=(const NearestFaceVertex&) = delete;
  /// Where it is.
  Vec3 to(const Vec3& point) const;

 private:
  FacePositions positions_;
  std::optional<NearestPoints> own_;
  const NearestPoints* search_;
};

}  // namespace pbffd
