#pragma once

#include "core/base/progress.h"
#include "core/ffd/control_set.h"
#include "core/ffd/weights/large_array.h"
#include "core/ffd/weights/level_values.h"
#include "core/mesh/rest_mesh.h"

#include <cstdint>
#include <vector>

namespace pbffd {

/// Which vertices each control point of the finest level moves, and how much: the matrix W of McDonnell &
/// Qin, eqs. (3), (5), (7), without its column of the master, which is what the others leave of 1.
///
/// Vertices are taken in the mesh's Morton order, 16 to a block ("slot" = place in that order). A block
/// lists once the control points that move any of its vertices, in ascending order, and holds their weights
/// as 16 floats a control point. Disabled points are in no list.
struct Parameterization {
  static constexpr Index blockSize = 16;

  /// B + 1 entries: block b has entries [blockStart[b], blockStart[b + 1]).
  std::vector<Index> blockStart{0};
  std::vector<Index> points;           ///< one an entry: the place of the control point in its level
  std::vector<std::uint16_t> members;  ///< one an entry: bit k, whether it moves the k-th vertex of the block
  LargeArray<float> weights;           ///< 16 an entry; 0 where not a member
  /// One a block: bit k, whether the master moves the k-th vertex (it does not where its own value is 0).
  std::vector<std::uint16_t> masterMembers;
  Index vertexCount = 0;
  Index pointCount = 0;

  Index blockCount() const { return static_cast<Index>(blockStart.size()) - 1; }
  BlockList list(Index block) const { return blockListOf(block, blockStart, points, members); }
};

/// Runs in parallel over points, then blocks; the result does not depend on the number of threads.
/// Throws Cancelled.
Parameterization parameterize(const RestMesh& mesh, const Basis& basis, const Master& master,
                              const Level& level, const Progress& progress = {});

/// The vertices that control point `point` counts (contract, section 4, `reach`), ascending, with the
/// squared distance |u|^2 of each. Looks at every vertex: for a few points, not for all.
struct Reached {
  std::vector<Index> vertices;
  std::vector<double> uSquared;
};
Reached reachedVertices(const RestMesh& mesh, const ControlPoint& point);

/// The normalised weights of free points (not mesh vertices) over a level: row i = point i; the places of
/// the control points in ascending order. A point counts as its nearest rest vertex for `reach`; in a region
/// that holds no vertex at all every point counts.
struct PointWeights {
  std::vector<Index> start;     ///< N + 1 entries
  std::vector<Index> points;    ///< the control points of row i: [start[i], start[i + 1])
  std::vector<double> weights;  ///< beside `points`
  std::vector<double> master;   ///< one a row; 0 for a row that nothing reaches, which then stays
};
PointWeights weightsAt(const Points& at, const RestMesh& mesh, const Basis& basis, const Master& master,
                       const Level& level, const Progress& progress = {});

/// The blend of the level's maps by row `row`: the map B of the contract; the identity where all weights
/// are 0.
AffineMap blendedMap(const PointWeights& weights, Index row, const LevelMaps& maps);

}  // namespace pbffd
