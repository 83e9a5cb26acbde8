#pragma once

#include "core/mesh/mesh.h"

#include <memory>
#include <vector>

namespace pbffd {

/// Whether each vertex has a face: the others are no part of the shape.
std::vector<bool> hasFaceFlags(const Mesh& mesh);

/// The positions of the vertices that have a face, in their order: the mesh's own, without a copy, where all
/// have one. The mesh lives as long and stays as it is.
class FacePositions {
 public:
  explicit FacePositions(const Mesh& mesh);
  const Points& points() const { return *points_; }

 private:
  std::unique_ptr<const Points> own_;
  const Points* points_;
};

}  // namespace pbffd
