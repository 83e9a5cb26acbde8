#pragma once

#include "core/mesh/triangle_tree.h"

#include <span>
#include <vector>

namespace pbffd {

/// The generalized winding number of a set of triangles about a point: 1 inside and 0 outside a closed
/// surface whose normals look outward, a fraction near holes (Jacobson, Kavan and Sorkine-Hornung 2013).
/// The exact sum over all triangles, in O(T) time.
double exactWindingNumber(const Points& positions, std::span<const Index> corners, const Vec3& point);

/// The same for many points: far parts of the surface count as a dipole and a quadrupole (Barill et al.
/// 2018), near triangles exactly. O(log T) a point; off by less than 0.05. The same
/// bits on every processor. Keeps a reference to the positions.
class WindingNumber {
 public:
  /// corners: 3 vertices a triangle. Coordinates must be finite.
  WindingNumber(const Points& positions, std::span<const Index> corners);

  double at(const Vec3& point) const;

  /// Whether the point is inside: a winding number above one half.
  bool isInside(const Vec3& point) const { return at(point) > 0.5; }

  /// The tree that it stands on, for questions about crossings.
  const TriangleTree& triangles() const { return tree_; }

 private:
  using Lanes = TriangleTree::Lanes;
  /// What the four children of a node look like from afar, in the unit cube of the tree, one lane each.
  struct Moments {
    Lanes center[3];
    Lanes nearSquared;    ///< closer than this (squared) a child is opened
    Lanes dipole[3];      ///< sum of area vectors
    Lanes trace;          ///< of the quadrupole
    Lanes quadrupole[6];  ///< sum of offset x area vector, symmetric part: xx, yy, zz, xy, yz, zx
  };
  struct Expansion;

  void build();
  Expansion expansionOfLeaf(Index leaf) const;
  /// near: a bit for each child that has to be opened.
  double farField(const Moments& moments, const Lanes* point, unsigned& near) const;

  TriangleTree tree_;
  std::vector<std::vector<Moments>> moments_;  ///< moments_[l]: of the nodes of level l + 1
};

}  // namespace pbffd
