#pragma once

#include "core/mesh/mesh.h"

#include <span>
#include <vector>

namespace pbffd {

/// The vertices of a mesh joined along the edges of its faces, with vertices at the very same position
/// taken as one. What `reach` walks on (contract, section 4).
class SurfaceGraph {
 public:
  explicit SurfaceGraph(const Mesh& mesh);

  /// The lowest vertex at the same position as `vertex`.
  Index representative(Index vertex) const { return representative_[vertex]; }

  /// The representatives joined by an edge to `representative`, in ascending order.
  std::span<const Index> neighbours(Index representative) const {
    return {neighbours_.data() + offsets_[representative], neighbours_.data() + offsets_[representative + 1]};
  }

  /// The connected component of a vertex; an isolated vertex is a component of its own.
  Index component(Index vertex) const { return component_[vertex]; }
  Index componentCount() const { return componentCount_; }

 private:
  void joinAlongEdges(const Polygons& faces);
  void numberComponents();

  std::vector<Index> representative_;
  std::vector<Index> offsets_;
  std::vector<Index> neighbours_;
  std::vector<Index> component_;
  Index componentCount_ = 0;
};

}  // namespace pbffd
