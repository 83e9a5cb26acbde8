#pragma once

#include "core/ffd/deform/deformation.h"
#include "core/mesh/rest_mesh.h"
#include "ui/views/mesh_actor.h"

#include <memory>
#include <vector>

namespace pbffd::ui {

/// The rest mesh as buffers to draw: what is seen until the weights are there.
class RestBuffers {
 public:
  explicit RestBuffers(const RestMesh& mesh);
  SurfaceBuffers buffers() const { return {&positions_, &normals_, &triangles_}; }
  const Vec3& origin() const { return origin_; }

 private:
  Vec3 origin_;
  std::vector<float> positions_;
  std::vector<float> normals_;
  std::vector<Index> triangles_;
};

/// Which surface is to be drawn now: the deformed one where there is one, else the mesh at rest.
class SurfaceStore {
 public:
  /// Returns whether other buffers than before are to be drawn (not merely other numbers in them).
  bool choose(const std::shared_ptr<const RestMesh>& mesh, const LiveDeformation* deformation);

  const std::shared_ptr<const RestMesh>& mesh() const { return mesh_; }
  /// All null when there is no mesh.
  const SurfaceBuffers& buffers() const { return buffers_; }
  const Vec3& origin() const { return origin_; }

 private:
  std::shared_ptr<const RestMesh> mesh_;
  std::unique_ptr<RestBuffers> rest_;
  SurfaceBuffers buffers_;
  /// Where the positions drawn last lie, or lay: their owner may be gone.
  const float* drawn_ = nullptr;
  Vec3 origin_ = Vec3::Zero();
};

}  // namespace pbffd::ui
