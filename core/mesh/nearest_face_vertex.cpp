#include "core/mesh/nearest_face_vertex.h"

namespace pbffd {

NearestFaceVertex::NearestFaceVertex(const RestMesh& mesh) : positions_(mesh.mesh()) {
  if (&positions_.points() == &mesh.positions()) {
    search_ = &mesh.nearestVertex();
  } else {
    search_ = &own_.emplace(positions_.points());
  }
}

Vec3 NearestFaceVertex::to(const Vec3& point) const {
  return positions_.points().row(search_->nearest(point).index);
}

}  // namespace pbffd
