#pragma once

#include "core/ffd/weights/large_array.h"
#include "core/mesh/rest_mesh.h"

#include <cstdint>
#include <vector>

namespace pbffd {

/// The mesh as it is deformed for the screen: vertices in slots (the mesh's Morton order), 16 to a block, in
/// single precision about the centre of the bounds.
class SlotMesh {
 public:
  explicit SlotMesh(const RestMesh& mesh);

  const Vec3& origin() const { return origin_; }
  Index slotCount() const { return slotCount_; }
  Index blockCount() const { return static_cast<Index>(triangleStart_.size()) - 1; }

  /// A block's 16 x, 16 y, 16 z; zero after the last vertex.
  const float* rest() const { return rest_.data(); }

  /// 3 slots a triangle, in the order of the mesh's triangles().
  const std::vector<Index>& triangleSlots() const { return triangleSlots_; }

  /// Which of `blocks` and their neighbours have a triangle with a corner in one of `blocks`; ascending.
  std::vector<Index> blocksAround(const std::vector<Index>& blocks) const;

  /// Writes the unit normals of a block's vertices: the sum of the normals of the triangles around, weighted
  /// by area. positions, normals: 3 a slot.
  void writeNormals(Index block, const std::vector<float>& positions, std::vector<float>& normals) const;

  /// The bytes of what is kept to find a block's triangles.
  std::size_t bytesOfLists() const;

 private:
  void fillRest(const RestMesh& mesh);
  void listTriangles();

  Vec3 origin_;
  Index slotCount_;
  float edgeScale_;  ///< keeps the normals of very small and very large meshes within single precision
  LargeArray<float> rest_;
  std::vector<Index> triangleSlots_;
  std::vector<Index> triangleStart_;  ///< block b has triangles [triangleStart_[b], triangleStart_[b + 1])
  std::vector<Index> triangles_;      ///< those with a corner in the block, ascending
};

}  // namespace pbffd
