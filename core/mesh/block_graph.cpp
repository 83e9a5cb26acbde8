#include "core/mesh/block_graph.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>

namespace pbffd {
namespace {

constexpr std::size_t grain = 256;

/// The slots joined to `seed` within the block.
unsigned joinedTo(unsigned seed, const std::uint16_t* joined) {
  unsigned reached = seed;
  for (unsigned left = seed; left != 0;) {
    const unsigned more = joined[std::countr_zero(left)] & ~reached;
    left = (left & (left - 1)) | more;
    reached |= more;
  }
  return reached;
}

}  // namespace

/// An edge that leaves its block.
struct BlockGraph::Crossing {
  Index block;        ///< where it leads
  std::uint8_t edge;  ///< 16 x the slot in this block + the slot in the other
  bool operator<(const Crossing& other) const {
    return block != other.block ? block < other.block : edge < other.edge;
  }
  bool operator==(const Crossing&) const = default;
};

/// The edges of the graph, by the blocks of the order.
class BlockGraph::Builder {
 public:
  Builder(const SurfaceGraph& graph, const std::vector<Index>& order)
      : graph_(graph), order_(order), slotOf_(order.size()), nextTwin_(order.size(), -1) {
    for (std::size_t slot = 0; slot < order.size(); ++slot) {
      slotOf_[static_cast<std::size_t>(order[slot])] = static_cast<Index>(slot);
    }
    for (std::size_t v = order.size(); v-- > 0;) {
      const auto first = static_cast<std::size_t>(graph.representative(static_cast<Index>(v)));
      if (first != v) {
        nextTwin_[v] = nextTwin_[first];
        nextTwin_[first] = static_cast<Index>(v);
      }
    }
  }

  /// Calls visit(k, other slot) for each edge of the block's k-th slot.
  template <class Visit>
  void forEachEdge(std::size_t block, const Visit& visit) const {
    const std::size_t end = std::min(order_.size(), (block + 1) * blockSize);
    for (std::size_t slot = block * blockSize; slot < end; ++slot) {
      const auto k = static_cast<unsigned>(slot % blockSize);
      const Index vertex = order_[slot];
      const Index first = graph_.representative(vertex);
      if (first != vertex) {
        visit(k, slotOf_[static_cast<std::size_t>(first)]);
        continue;
      }
      for (Index twin = nextTwin_[static_cast<std::size_t>(vertex)]; twin >= 0;
           twin = nextTwin_[static_cast<std::size_t>(twin)]) {
        visit(k, slotOf_[static_cast<std::size_t>(twin)]);
      }
      for (const Index next : graph_.neighbours(vertex)) {
        visit(k, slotOf_[static_cast<std::size_t>(next)]);
      }
    }
  }

  /// The edges that leave the block, ordered by where they lead.
  void crossings(std::size_t block, std::vector<Crossing>& found) const {
    found.clear();
    forEachEdge(block, [&](unsigned k, Index slot) {
      if (const Index other = slot / blockSize; other != static_cast<Index>(block)) {
        found.push_back({other, static_cast<std::uint8_t>(16 * k + static_cast<unsigned>(slot % blockSize))});
      }
    });
    std::sort(found.begin(), found.end());
  }

 private:
  const SurfaceGraph& graph_;
  const std::vector<Index>& order_;
  std::vector<Index> slotOf_;
  std::vector<Index> nextTwin_;  ///< from a representative through all others at its position; -1 ends
};

BlockGraph::BlockGraph(const SurfaceGraph& graph, const std::vector<Index>& order) {
  const Builder builder(graph, order);
  const std::size_t count = (order.size() + blockSize - 1) / blockSize;
  all_.assign(count, std::numeric_limits<std::uint16_t>::max());
  if (const std::size_t rest = order.size() % blockSize; rest != 0) {
    all_.back() = static_cast<std::uint16_t>((1U << rest) - 1);
  }
  joinInside(builder);
  link(builder);
}

void BlockGraph::joinInside(const Builder& builder) {
  joined_.assign(all_.size() * blockSize, 0);
  isOne_.resize(all_.size());
  parallelFor(all_.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      builder.forEachEdge(b, [&](unsigned k, Index slot) {
        if (slot / blockSize == static_cast<Index>(b)) {
          joined_[b * blockSize + k] |= static_cast<std::uint16_t>(1U << (slot % blockSize));
        }
      });
      isOne_[b] = joinedTo(1, &joined_[b * blockSize]) == all_[b];
    }
  });
}

/// Counts the edges and links of each block, then fills them in.
void BlockGraph::link(const Builder& builder) {
  linkStart_.assign(all_.size() + 1, 0);
  std::vector<std::uint32_t> edgeStart(all_.size() + 1, 0);
  parallelFor(all_.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Crossing> found;
    for (std::size_t b = begin; b < end; ++b) {
      builder.crossings(b, found);
      edgeStart[b + 1] = static_cast<std::uint32_t>(found.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        linkStart_[b + 1] += i == 0 || found[i].block != found[i - 1].block;
      }
    }
  });
  std::partial_sum(linkStart_.begin(), linkStart_.end(), linkStart_.begin());
  std::partial_sum(edgeStart.begin(), edgeStart.end(), edgeStart.begin());
  links_.resize(static_cast<std::size_t>(linkStart_.back()) + 1);
  links_.back().edgeStart = edgeStart.back();
  edges_.resize(edgeStart.back());
  parallelFor(all_.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Crossing> found;
    for (std::size_t b = begin; b < end; ++b) {
      builder.crossings(b, found);
      fillLinks(found, static_cast<std::size_t>(linkStart_[b]), edgeStart[b]);
    }
  });
}

void BlockGraph::fillLinks(const std::vector<Crossing>& crossings, std::size_t link, std::uint32_t edge) {
  for (std::size_t i = 0; i < crossings.size(); ++i, ++edge) {
    if (i == 0 || crossings[i].block != crossings[i - 1].block) {
      links_[link++] = {crossings[i].block, 0, 0, edge};
    }
    links_[link - 1].from |= static_cast<std::uint16_t>(1U << (crossings[i].edge >> 4U));
    links_[link - 1].to |= static_cast<std::uint16_t>(1U << (crossings[i].edge & 15U));
    edges_[edge] = crossings[i].edge;
  }
}

std::uint16_t BlockGraph::joinedAcross(const Link& link, std::uint16_t from) const {
  if ((link.from & ~from) == 0) {
    return link.to;
  }
  unsigned joined = 0;
  const std::uint32_t end = (&link + 1)->edgeStart;
  for (std::uint32_t e = link.edgeStart; e < end; ++e) {
    joined |= (from >> (edges_[e] >> 4U) & 1U) << (edges_[e] & 15U);
  }
  return static_cast<std::uint16_t>(joined);
}

}  // namespace pbffd
