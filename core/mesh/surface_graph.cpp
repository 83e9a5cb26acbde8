#include "core/mesh/surface_graph.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pbffd {
namespace {

/// The lowest vertex at the same position, for each vertex.
std::vector<Index> weld(const Points& positions) {
  std::vector<Index> order(static_cast<std::size_t>(positions.rows()));
  std::iota(order.begin(), order.end(), 0);
  const auto before = [&](Index a, Index b) {
    for (int axis = 0; axis < 3; ++axis) {
      if (positions(a, axis) != positions(b, axis)) {
        return positions(a, axis) < positions(b, axis);
      }
    }
    return a < b;
  };
  std::sort(order.begin(), order.end(), before);
  std::vector<Index> representative(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool isSame = i > 0 && positions.row(order[i]) == positions.row(order[i - 1]);
    representative[order[i]] = isSame ? representative[order[i - 1]] : order[i];
  }
  return representative;
}

/// Every edge once from each end, sorted, between representatives.
std::vector<std::pair<Index, Index>> directedEdges(const Polygons& faces,
                                                   const std::vector<Index>& representative) {
  std::vector<std::pair<Index, Index>> edges;
  edges.reserve(2 * faces.vertices().size());
  for (Index f = 0; f < faces.size(); ++f) {
    const auto face = faces[f];
    for (std::size_t c = 0; c < face.size(); ++c) {
      const Index a = representative[face[c]];
      const Index b = representative[face[(c + 1) % face.size()]];
      if (a != b) {
        edges.emplace_back(a, b);
        edges.emplace_back(b, a);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace

SurfaceGraph::SurfaceGraph(const Mesh& mesh) : representative_(weld(mesh.positions)) {
  const std::size_t count = representative_.size();
  const auto edges = directedEdges(mesh.faces, representative_);
  offsets_.assign(count + 1, 0);
  neighbours_.reserve(edges.size());
  for (const auto& [from, to] : edges) {
    ++offsets_[from + 1];
    neighbours_.push_back(to);
  }
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());

  component_.assign(count, -1);
  std::vector<Index> stack;
  for (std::size_t v = 0; v < count; ++v) {
    if (const Index seed = representative_[v]; component_[seed] < 0) {
      component_[seed] = componentCount_;
      stack.push_back(seed);
      while (!stack.empty()) {
        const Index at = stack.back();
        stack.pop_back();
        for (const Index next : neighbours(at)) {
          if (component_[next] < 0) {
            component_[next] = componentCount_;
            stack.push_back(next);
          }
        }
      }
      ++componentCount_;
    }
    component_[v] = component_[representative_[v]];
  }
}

}  // namespace pbffd
