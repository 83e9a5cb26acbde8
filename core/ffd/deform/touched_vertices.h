#pragma once

#include "core/base/parallel.h"
#include "core/ffd/deform/displacement.h"

#include <algorithm>

namespace pbffd {

/// The basis values of one block of vertices at a time, beside the displacements that they weigh: the base of
/// what is evaluated in double precision at vertices. Its memory is used again from block to block.
class BlockEvaluator {
 public:
  BlockEvaluator(const LevelValues& level, const PointBlocks& blocks, const LevelDisplacements& displacements)
      : level_(&level), blocks_(&blocks), displacements_(&displacements), values_(level, blocks) {}

  void evaluate(Index block, const BlockList& list) {
    block_ = block;
    list_ = list;
    values_.evaluate(block, list);
  }

 protected:
  Vec3 point(Index k) const { return blocks_->point(block_, k); }
  /// Whether the e-th control point of the list moves the k-th vertex of the block.
  bool isMember(std::size_t e, Index k) const { return (list_.members[e] >> k & 1) != 0; }

  const LevelValues* level_;
  const PointBlocks* blocks_;
  const LevelDisplacements* displacements_;
  BlockValues values_;
  Index block_ = 0;
  BlockList list_;
};

/// The vertices of a mesh that a deformation may move, block by block on all cores.
class TouchedVertices {
 public:
  /// Throws InvalidInput when the weights are not of this mesh and level. Keeps references.
  TouchedVertices(const RestMesh& mesh, const ControlSet& set, const Parameterization& weights)
      : mesh_(&mesh), set_(&set), weights_(&weights), displacements_(set.master, set.finest()) {
    requireFitting(weights, mesh, set.finest());
  }

  bool areAny() const { return displacements_.isAnyMoved(); }

  /// store(vertex, value) once a vertex, with the value of Evaluator::at(k), a BlockEvaluator. Throws
  /// Cancelled.
  template <class Evaluator, class Store>
  void forEach(const Progress& progress, const Store& store) const {
    constexpr std::size_t grain = 64;
    const std::vector<Index>& order = mesh_->mortonOrder();
    const PointBlocks blocks(mesh_->positions(), order);
    const LevelValues values(set_->basis, set_->master, set_->finest());
    const auto count = static_cast<std::size_t>(blocks.blockCount());
    parallelFor(count, grain, [&](std::size_t begin, std::size_t end) {
      progress.throwIfCancelled();
      Evaluator evaluator(values, blocks, displacements_);
      for (auto b = static_cast<Index>(begin); b < static_cast<Index>(end); ++b) {
        const BlockList list = weights_->list(b);
        if (!displacements_.touches(list)) {
          continue;
        }
        evaluator.evaluate(b, list);
        const Index first = b * PointBlocks::blockSize;
        for (Index k = 0; k < std::min(PointBlocks::blockSize, mesh_->vertexCount() - first); ++k) {
          store(order[static_cast<std::size_t>(first + k)], evaluator.at(k));
        }
      }
    });
  }

 private:
  const RestMesh* mesh_;
  const ControlSet* set_;
  const Parameterization* weights_;
  LevelDisplacements displacements_;
};

}  // namespace pbffd
