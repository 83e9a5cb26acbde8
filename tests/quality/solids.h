#pragma once

#include "core/mesh/mesh.h"

namespace pbffd::test {

// The closed solids of the deformation tasks, evenly meshed. They run along x from 0 to their length.

/// A bar of square cross section: `across` x `across` quads at its ends, `along` rings of quads between.
struct BarSize {
  double length = 6.0;
  double width = 1.0;
  int across = 12;
  int along = 123;
};
Mesh squareBar(const BarSize& size);

/// A round trunk with a round branch that grows out of its side towards +y: one closed surface. A patch of
/// across x across quads is left out of the trunk, and the branch's rings begin at its border.
struct CactusSize {
  double length = 6.0;
  double radius = 0.5;
  int rings = 91;
  int segments = 42;
  int branchRing = 54;  ///< the trunk's ring that the branch's axis starts from
  double branchRadius = 0.25;
  double reach = 2.2;  ///< of the branch's tip, from the trunk's axis
  int across = 6;      ///< even; the branch has 4 x across segments
  int branchRings = 40;

  double branchAt() const { return length * branchRing / (rings - 1); }
};
Mesh cactus(const CactusSize& size);

}  // namespace pbffd::test
