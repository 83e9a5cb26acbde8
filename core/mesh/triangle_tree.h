#pragma once

#include "core/mesh/mesh.h"

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace pbffd {

/// A tree over triangles: leaves of 8 triangles in Morton order, and above them levels on which each node has
/// four children, the node's number times four and the three that follow. Keeps a reference to the positions.
class TriangleTree {
 public:
  static constexpr Index leafSize = 8;
  static constexpr Index arity = 4;
  using Lanes = Eigen::Array<float, arity, 1>;

  /// corners: 3 vertices a triangle. Coordinates must be finite.
  TriangleTree(const Points& positions, std::span<const Index> corners);

  /// Whether a triangle meets the segment between the two points. Touching a border may count either way.
  bool isCrossed(const Vec3& from, const Vec3& to) const;

  /// Level 0 are the leaves; the last level is one node. No triangles: no levels.
  Index levelCount() const { return static_cast<Index>(nodeCounts_.size()); }
  Index nodeCount(Index level) const { return nodeCounts_[level]; }

  Index triangleCount() const { return static_cast<Index>(corners_.size()) / 3; }
  /// Corner k of the triangle at a place of the tree's order; leaf n has places [8 n, 8 n + 8).
  Vec3 corner(Index place, int k) const { return positions_.row(corners_[3 * place + k]); }

  /// The corners of a leaf's triangles seen from a point, in the scale of the unit cube: x, y, z of the first
  /// ones, of the second ones and of the third ones. Places without a triangle hold one without area.
  using LeafLanes = Eigen::Array<float, leafSize, 1>;
  using LeafCorners = std::array<LeafLanes, 9>;
  void cornersOfLeaf(Index leaf, const Vec3& from, LeafCorners& corners) const;

  /// The centre and the scale that take the mesh into a cube of edge length 1 about the origin.
  const Vec3& origin() const { return origin_; }
  double scale() const { return scale_; }

 private:
  /// The boxes of the four children of a node, in the unit cube, one lane each.
  struct Boxes {
    Lanes low[3];
    Lanes high[3];
  };
  struct Segment;

  void buildBoxes();
  bool isCrossedByLeaf(Index leaf, const Segment& segment) const;

  const Points& positions_;
  std::vector<Index> corners_;
  Vec3 origin_ = Vec3::Zero();
  double scale_ = 1.0;
  std::vector<Index> nodeCounts_;
  std::vector<std::vector<Boxes>> boxes_;  ///< boxes_[l]: of the nodes of level l + 1
};

}  // namespace pbffd
