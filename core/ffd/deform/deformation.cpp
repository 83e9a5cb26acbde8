#include "core/ffd/deform/deformation.h"

#include "core/base/parallel.h"
#include "core/ffd/deform/displacement.h"

#include <algorithm>

namespace pbffd {
namespace {

constexpr std::size_t blockGrain = 64;

/// One block at a time, with memory that is used again.
class ExactBlocks {
 public:
  ExactBlocks(const LevelValues& values, const PointBlocks& blocks, const LevelDisplacements& displacements)
      : values_(values, blocks), blocks_(&blocks), displacements_(&displacements) {}

  void evaluate(Index block, const BlockList& list) {
    block_ = block;
    list_ = list;
    values_.evaluate(block, list);
  }

  /// The deformed k-th point of the block: its very bits where nothing that moved reaches it.
  Vec3 deformed(Index k) const {
    const Vec3 rest = blocks_->point(block_, k);
    const auto lane = static_cast<std::size_t>(k);
    const double toWeight = values_.toWeight()[lane];
    Vec3 sum = Vec3::Zero();
    bool isReached = false;
    for (std::size_t e = 0; e < list_.points.size(); ++e) {
      const auto j = static_cast<std::size_t>(list_.points[e]);
      if (displacements_->isMoved[j] != 0 && (list_.members[e] >> k & 1) != 0) {
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

 private:
  BlockValues values_;
  const PointBlocks* blocks_;
  const LevelDisplacements* displacements_;
  Index block_ = 0;
  BlockList list_;
};

}  // namespace

Points deformExactly(const RestMesh& mesh, const ControlSet& set, const Parameterization& parameterization,
                     const Progress& progress) {
  requireFitting(parameterization, mesh, set.finest());
  const LevelDisplacements displacements(set.master, set.finest());
  Points deformed = mesh.positions();
  if (!displacements.isAnyMoved()) {
    return deformed;
  }
  progress.report("Deforming");
  const std::vector<Index>& order = mesh.mortonOrder();
  const PointBlocks blocks(mesh.positions(), order);
  const LevelValues values(set.basis, set.master, set.finest());
  parallelFor(static_cast<std::size_t>(blocks.blockCount()), blockGrain,
              [&](std::size_t begin, std::size_t end) {
                progress.throwIfCancelled();
                ExactBlocks exact(values, blocks, displacements);
                for (auto b = static_cast<Index>(begin); b < static_cast<Index>(end); ++b) {
                  const BlockList list = parameterization.list(b);
                  if (!displacements.touches(list)) {
                    continue;
                  }
                  exact.evaluate(b, list);
                  const Index first = b * PointBlocks::blockSize;
                  for (Index k = 0; k < std::min(PointBlocks::blockSize, mesh.vertexCount() - first); ++k) {
                    deformed.row(order[static_cast<std::size_t>(first + k)]) = exact.deformed(k);
                  }
                }
              });
  return deformed;
}

}  // namespace pbffd
