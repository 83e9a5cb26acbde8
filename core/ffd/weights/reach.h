#pragma once

#include "core/ffd/control_point.h"
#include "core/mesh/surface_graph.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace pbffd {

/// Decides which vertices a control point with Reach::connected counts (contract, section 4): a walk over
/// the surface inside one region at a time, with memory that is used again for the next.
class ReachWalk {
 public:
  explicit ReachWalk(const SurfaceGraph& graph, Index vertexCount)
      : graph_(&graph), marks_(static_cast<std::size_t>(vertexCount), 0) {}

  /// Walks from the vertex of least |u| (the lowest on a tie) to all that are joined to it inside.
  /// inside: the vertices of the region; uSquared: beside them.
  void start(const std::vector<Index>& inside, const std::vector<double>& uSquared);

  /// Whether the vertex counts in the region that the walk was started in. Of a region without a vertex
  /// every vertex counts.
  bool counts(Index vertex) const {
    return component_ < 0 || graph_->component(vertex) != component_ || wasReached(vertex);
  }

 private:
  bool wasReached(Index vertex) const {
    return marks_[static_cast<std::size_t>(graph_->representative(vertex))] == stamp_ + 1;
  }
  void flood(Index seed);

  const SurfaceGraph* graph_;
  std::vector<std::uint32_t> marks_;  ///< a representative: stamp_ inside the region, stamp_ + 1 reached
  std::uint32_t stamp_ = 0;
  Index component_ = -1;  ///< of the nearest vertex
  std::vector<Index> stack_;
};

/// Lends walks to the ranges of a parallel loop, so that there are only as many as run at a time.
class ReachWalks {
 public:
  ReachWalks(const SurfaceGraph& graph, Index vertexCount) : graph_(&graph), vertexCount_(vertexCount) {}

  class GiveBack {
   public:
    explicit GiveBack(ReachWalks* owner = nullptr) : owner_(owner) {}
    void operator()(ReachWalk* walk) const { owner_->giveBack(std::unique_ptr<ReachWalk>(walk)); }

   private:
    ReachWalks* owner_;
  };
  /// A walk for as long as this lives.
  using Loan = std::unique_ptr<ReachWalk, GiveBack>;
  Loan take();

 private:
  void giveBack(std::unique_ptr<ReachWalk> walk);

  const SurfaceGraph* graph_;
  Index vertexCount_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<ReachWalk>> idle_;
};

}  // namespace pbffd
