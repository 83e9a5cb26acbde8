#include "ui/views/mesh_edges.h"

#include <algorithm>
#include <cstdint>

namespace pbffd::ui {
namespace {

/// Pairs of slots, the smaller first, in ascending order, each once.
std::vector<std::uint64_t> uniqueEdges(const Polygons& faces, const std::vector<Index>& slotOfVertex) {
  std::vector<std::uint64_t> edges;
  edges.reserve(faces.vertices().size());
  for (Index f = 0; f < faces.size(); ++f) {
    const auto corners = faces[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Index a = slotOfVertex[corners[i]];
      const Index b = slotOfVertex[corners[(i + 1) % corners.size()]];
      if (a != b) {
        edges.push_back(static_cast<std::uint64_t>(std::min(a, b)) << 32 |
                        static_cast<std::uint32_t>(std::max(a, b)));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace

MeshEdges meshEdges(const RestMesh& mesh) {
  const std::vector<Index>& order = mesh.mortonOrder();
  std::vector<Index> slotOfVertex(order.size());
  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    slotOfVertex[order[slot]] = static_cast<Index>(slot);
  }
  MeshEdges result;
  result.meanLengths.assign(order.size(), 0.0F);
  std::vector<int> valence(order.size(), 0);
  for (const std::uint64_t edge : uniqueEdges(mesh.mesh().faces, slotOfVertex)) {
    const auto a = static_cast<Index>(edge >> 32);
    const auto b = static_cast<Index>(edge & 0xffffffffU);
    const auto length =
        static_cast<float>((mesh.positions().row(order[a]) - mesh.positions().row(order[b])).norm());
    for (const Index end : {a, b}) {
      result.slots.push_back(end);
      result.meanLengths[end] += length;
      ++valence[end];
    }
  }
  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    result.meanLengths[slot] /= static_cast<float>(std::max(valence[slot], 1));
  }
  return result;
}

}  // namespace pbffd::ui
