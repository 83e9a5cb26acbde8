#include "ui/views/surface_store.h"

#include <utility>

namespace pbffd::ui {

RestBuffers::RestBuffers(const RestMesh& mesh) : origin_(mesh.bounds().center()) {
  const std::vector<Index>& order = mesh.mortonOrder();
  const Points& normals = mesh.normals();
  std::vector<Index> slotOfVertex(order.size());
  positions_.reserve(3 * order.size());
  normals_.reserve(3 * order.size());
  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    slotOfVertex[order[slot]] = static_cast<Index>(slot);
    for (int i = 0; i < 3; ++i) {
      positions_.push_back(static_cast<float>(mesh.positions()(order[slot], i) - origin_[i]));
      normals_.push_back(static_cast<float>(normals(order[slot], i)));
    }
  }
  triangles_.reserve(mesh.triangles().vertices().size());
  for (const Index vertex : mesh.triangles().vertices()) {
    triangles_.push_back(slotOfVertex[vertex]);
  }
}

bool SurfaceStore::choose(const std::shared_ptr<const RestMesh>& mesh, const LiveDeformation* deformation) {
  const bool isOtherMesh = mesh != mesh_;
  if (isOtherMesh) {
    mesh_ = mesh;
    rest_.reset();
  }
  buffers_ = {};
  if (mesh_ == nullptr) {
    drawn_ = nullptr;
    return isOtherMesh;
  }
  if (deformation != nullptr) {
    rest_.reset();
    buffers_ = {&deformation->positions(), &deformation->normals(), &deformation->triangleSlots()};
    origin_ = deformation->origin();
  } else {
    if (rest_ == nullptr) {
      rest_ = std::make_unique<RestBuffers>(*mesh_);
    }
    buffers_ = rest_->buffers();
    origin_ = rest_->origin();
  }
  const float* const before = std::exchange(drawn_, buffers_.positions->data());
  return isOtherMesh || drawn_ != before;
}

}  // namespace pbffd::ui
