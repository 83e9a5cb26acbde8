#pragma once

#include "core/ffd/weights/point_blocks.h"
#include "core/mesh/rest_mesh.h"

namespace pbffd {

/// The nearest vertices of many places near each other, several times as fast as RestMesh::nearestVertex(): 16
/// vertices or 8 boxes at a time, beginning from what a neighbour found.
class NearestVertices {
 public:
  /// Keeps a reference to the mesh, which has a vertex.
  explicit NearestVertices(const RestMesh& mesh);

  /// The nearest vertex, the lowest index on a tie. `guess`: any vertex; a near one saves time.
  Index nearest(const Vec3& place, Index guess) const;

 private:
  const RestMesh& mesh_;
  PointBlocks blocks_;
};

}  // namespace pbffd
