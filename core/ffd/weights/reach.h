#pragma once

#include "core/ffd/control_point.h"
#include "core/ffd/weights/membership.h"
#include "core/mesh/rest_mesh.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace pbffd {

/// Decides which vertices a control point with Reach::connected counts (contract, section 4): a walk over
/// the surface inside one region at a time, block by block, with memory that is used again for the next.
class ReachWalk {
 public:
  explicit ReachWalk(const RestMesh& mesh);

  /// Walks from the vertex of least |u| (the lowest on a tie) to all that are joined to it inside.
  /// vertices: the mesh's, in its Morton order; inside: those in the region.
  void start(const PointBlocks& vertices, const Region& region, const Membership& inside);

  /// Whether the vertex at this place of the order counts in the region that the walk was started in. Of a
  /// region without a vertex every vertex counts.
  bool counts(Index slot) const {
    const auto block = static_cast<std::size_t>(slot / BlockGraph::blockSize);
    return component_ < 0 || (states_[block].reached >> (slot % BlockGraph::blockSize) & 1) != 0 ||
           componentOf(slot) != component_;
  }

  /// Those of a membership of the mesh's vertices that count.
  Membership counted(const Membership& membership) const;

  /// The component of the surface that was walked on; -1 before the first region and for one without a vertex.
  Index component() const { return component_; }

 private:
  /// Of one block; nothing is set where the region has no vertex.
  struct State {
    std::uint16_t inside = 0;
    std::uint16_t reached = 0;
    std::uint16_t fresh = 0;  ///< reached, but not walked on from
  };
  Index componentOf(Index slot) const {
    return mesh_->graph().component((*order_)[static_cast<std::size_t>(slot)]);
  }
  Index nearest(const PointBlocks& vertices, const Region& region, const Membership& inside) const;
  void flood(Index slot);
  void add(Index block, unsigned slots);
  std::uint16_t spreadInside(Index block);

  const RestMesh* mesh_;
  const BlockGraph* graph_;
  const std::vector<Index>* order_;
  std::vector<State> states_;
  std::vector<Index> used_;  ///< the blocks whose state is set
  std::vector<Index> open_;  ///< the blocks with fresh slots
  Index component_ = -1;
};

/// Lends walks to the ranges of a parallel loop, so that there are only as many as run at a time.
class ReachWalks {
 public:
  explicit ReachWalks(const RestMesh& mesh) : mesh_(&mesh) {}

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

  const RestMesh* mesh_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<ReachWalk>> idle_;
};

/// The vertices that the point counts, whether it is enabled or not. vertices: the mesh's, in Morton order.
Membership reachedBy(const ControlPoint& point, const PointBlocks& vertices, ReachWalks& walks);

}  // namespace pbffd
