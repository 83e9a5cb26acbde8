#include "ui/views/mesh_edges.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <numeric>

namespace pbffd::ui {
namespace {

/// Calls visit(smaller, larger) for the slots at the ends of every side of every polygon.
template <class Visit>
void forEachSide(const Polygons& faces, const std::vector<Index>& slotOfVertex, const Visit& visit) {
  for (Index f = 0; f < faces.size(); ++f) {
    const auto corners = faces[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Index a = slotOfVertex[corners[i]];
      const Index b = slotOfVertex[corners[i + 1 < corners.size() ? i + 1 : 0]];
      if (a != b) {
        visit(std::min(a, b), std::max(a, b));
      }
    }
  }
}

/// The edges by their smaller slot: of slot s those to ends[start[s]] up to, without, ends[start[s] +
/// count[s]], ascending, each once.
struct EdgesBySlot {
  std::vector<std::size_t> start;
  std::vector<Index> count;
  std::vector<Index> ends;
};

EdgesBySlot edgesBySlot(const Polygons& faces, const std::vector<Index>& slotOfVertex) {
  EdgesBySlot edges;
  edges.start.assign(slotOfVertex.size() + 1, 0);
  edges.count.assign(slotOfVertex.size(), 0);
  forEachSide(faces, slotOfVertex, [&](Index smaller, Index) { ++edges.start[smaller + 1]; });
  std::partial_sum(edges.start.begin(), edges.start.end(), edges.start.begin());
  edges.ends.resize(edges.start.back());
  forEachSide(faces, slotOfVertex, [&](Index smaller, Index larger) {
    edges.ends[edges.start[smaller] + static_cast<std::size_t>(edges.count[smaller]++)] = larger;
  });
  constexpr std::size_t grain = 4096;
  parallelFor(slotOfVertex.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      const auto first = edges.ends.begin() + static_cast<std::ptrdiff_t>(edges.start[slot]);
      const auto last = first + edges.count[slot];
      std::sort(first, last);
      edges.count[slot] = static_cast<Index>(std::unique(first, last) - first);
    }
  });
  return edges;
}

}  // namespace

MeshEdges meshEdges(const RestMesh& mesh) {
  const std::vector<Index>& order = mesh.mortonOrder();
  std::vector<Index> slotOfVertex(order.size());
  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    slotOfVertex[order[slot]] = static_cast<Index>(slot);
  }
  const EdgesBySlot edges = edgesBySlot(mesh.mesh().faces, slotOfVertex);
  MeshEdges result;
  result.slots.reserve(edges.ends.size());
  result.meanLengths.assign(order.size(), 0.0F);
  std::vector<int> valence(order.size(), 0);
  const auto add = [&](Index a, Index b) {
    const auto length =
        static_cast<float>((mesh.positions().row(order[a]) - mesh.positions().row(order[b])).norm());
    for (const Index end : {a, b}) {
      result.slots.push_back(end);
      result.meanLengths[end] += length;
      ++valence[end];
    }
  };
  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    for (Index k = 0; k < edges.count[slot]; ++k) {
      add(static_cast<Index>(slot), edges.ends[edges.start[slot] + static_cast<std::size_t>(k)]);
    }
  }
  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    result.meanLengths[slot] /= static_cast<float>(std::max(valence[slot], 1));
  }
  return result;
}

}  // namespace pbffd::ui
