#include "core/ffd/deform/deformation.h"

#include "core/ffd/deform/touched_vertices.h"

namespace pbffd {
namespace {

class ExactPositions : public BlockEvaluator {
 public:
  using BlockEvaluator::BlockEvaluator;

  /// The deformed k-th vertex of the block: its very bits where nothing that moved reaches it.
  Vec3 at(Index k) const {
    const Vec3 rest = point(k);
    const auto lane = static_cast<std::size_t>(k);
    const double toWeight = values_.toWeight()[lane];
    Vec3 sum = Vec3::Zero();
    bool isReached = false;
    for (std::size_t e = 0; e < list_.points.size(); ++e) {
      const auto j = static_cast<std::size_t>(list_.points[e]);
      if (displacements_->isMoved[j] != 0 && isMember(e, k)) {
        sum += values_.entries()[e][lane] * toWeight * displacements_->points[j](rest);
        isReached = true;
      }
    }
    if (displacements_->isMasterMoved) {
      sum += values_.master()[lane] * toWeight * displacements_->master(rest);
      isReached = true;
    }
    return isReached && toWeight > 0.0 ? Vec3(rest + sum) : rest;
  }
};

}  // namespace

Points deformExactly(const RestMesh& mesh, const ControlSet& set, const Parameterization& parameterization,
                     const Progress& progress) {
  const TouchedVertices touched(mesh, set, parameterization);
  Points deformed = mesh.positions();
  if (touched.areAny()) {
    progress.report("Deforming");
    touched.forEach<ExactPositions>(
        progress, [&](Index vertex, const Vec3& position) { deformed.row(vertex) = position; });
  }
  return deformed;
}

}  // namespace pbffd
