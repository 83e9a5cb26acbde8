#pragma once

#include "core/mesh/surface_graph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace pbffd {

/// The surface graph in blocks of 16 slots of an order: a walk over it goes block by block, 16 vertices in
/// one number, and looks at single edges only where a region cuts through a block. About 11 bytes a vertex.
class BlockGraph {
 public:
  static constexpr Index blockSize = 16;

  /// All edges from one block to another.
  struct Link {
    Index block;              ///< the other
    std::uint16_t from;       ///< the slots of this block that have such an edge
    std::uint16_t to;         ///< the slots of the other that they join
    std::uint32_t edgeStart;  ///< where its entries of edges() begin
  };

  /// order[slot] = vertex, every vertex once. Vertices at the same position are joined.
  BlockGraph(const SurfaceGraph& graph, const std::vector<Index>& order);

  Index blockCount() const { return static_cast<Index>(all_.size()); }

  /// The slots of the block that hold a vertex; all but in the last block.
  std::uint16_t all(Index block) const { return all_[static_cast<std::size_t>(block)]; }
  /// Whether its slots are all joined to each other without leaving it.
  bool isOne(Index block) const { return isOne_[static_cast<std::size_t>(block)] != 0; }
  /// The slots of the same block that the slot has an edge to.
  std::uint16_t joined(Index slot) const { return joined_[static_cast<std::size_t>(slot)]; }

  std::span<const Link> links(Index block) const {
    const auto at = static_cast<std::size_t>(block);
    return {links_.data() + linkStart_[at], links_.data() + linkStart_[at + 1]};
  }
  /// What the slots `from` of the link's block join in its other block.
  std::uint16_t joinedAcross(const Link& link, std::uint16_t from) const;

 private:
  class Builder;
  struct Crossing;
  void joinInside(const Builder& builder);
  void link(const Builder& builder);
  void fillLinks(const std::vector<Crossing>& crossings, std::size_t link, std::uint32_t edge);

  std::vector<std::uint16_t> all_;
  std::vector<std::uint8_t> isOne_;
  std::vector<std::uint16_t> joined_;
  std::vector<Index> linkStart_;
  std::vector<Link> links_;          ///< block by block, ascending in the other; one more, the end of edges_
  std::vector<std::uint8_t> edges_;  ///< 16 x the slot in this block + the slot in the other
};

}  // namespace pbffd
