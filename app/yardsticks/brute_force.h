#pragma once

#include "core/ffd/weights/parameterization.h"

#include <vector>

namespace pbffd {

/// What parameterize() gives, by vertices and without its search: the control points that move each vertex,
/// ascending, and their normalised weights.
struct VertexWeights {
  /// As many vertices in a row as a thread takes at a time.
  struct Run {
    std::vector<Index> start{0};  ///< the k-th vertex of the run has entries [start[k], start[k + 1])
    std::vector<Index> points;
    std::vector<float> weights;
  };
  Index runLength = 1;
  std::vector<Run> runs;
};

/// Every vertex against every control point by the letter of McDonnell & Qin, eqs. (1), (3) and (5), as if all
/// regions were whole (`reach` all), on all cores.
VertexWeights weightsByBruteForce(const RestMesh& mesh, const Basis& basis, const Master& master,
                                  const Level& level);

/// The same with the level's `reach`: for each control point a look at every vertex and a walk over those
/// inside.
VertexWeights weightsByWalking(const RestMesh& mesh, const Basis& basis, const Master& master,
                               const Level& level);

/// By how much a weight differs at most; where one of the two has no entry, its weight counts as 0.
double greatestDifference(const VertexWeights& weights, const Parameterization& parameterization,
                          const RestMesh& mesh);

}  // namespace pbffd
