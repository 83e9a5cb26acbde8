#include "core/mesh/surface_graph.h"

#include "core/base/parallel.h"
#include "core/mesh/edge_list.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pbffd {
namespace {

/// The lowest vertex at the same position, for each vertex.
std::vector<Index> weld(const Points& positions) {
  // Sorted by one number, those that may be the same lie side by side.
  std::vector<std::pair<double, Index>> order(static_cast<std::size_t>(positions.rows()));
  for (std::size_t v = 0; v < order.size(); ++v) {
    const auto at = positions.row(static_cast<Index>(v));
    const double key = at[0] + 0.7548776662466927 * at[1] + 0.5698402909980532 * at[2];
    order[v] = {std::isfinite(key) ? key : 0.0, static_cast<Index>(v)};
  }
  parallelSort(order);
  std::vector<Index> representative(order.size());
  std::iota(representative.begin(), representative.end(), 0);
  for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
    for (end = begin + 1; end < order.size() && order[end].first == order[begin].first; ++end) {
      const Index vertex = order[end].second;
      for (std::size_t i = begin; i < end; ++i) {
        if (positions.row(order[i].second) == positions.row(vertex)) {
          representative[vertex] = representative[order[i].second];
          break;
        }
      }
    }
  }
  return representative;
}

/// Calls visit(a, b) for every edge of every face, between representatives.
template <class Visit>
void forEachEdge(const Polygons& faces, const std::vector<Index>& representative, const Visit& visit) {
  for (Index f = 0; f < faces.size(); ++f) {
    const auto face = faces[f];
    for (std::size_t c = 0; c < face.size(); ++c) {
      const Index a = representative[face[c]];
      const Index b = representative[face[c + 1 < face.size() ? c + 1 : 0]];
      if (a != b) {
        visit(a, b);
      }
    }
  }
}

}  // namespace

SurfaceGraph::SurfaceGraph(const Mesh& mesh) : representative_(weld(mesh.positions)) {
  joinAlongEdges(mesh.faces);
  numberComponents();
}

void SurfaceGraph::joinAlongEdges(const Polygons& faces) {
  const auto count = static_cast<Index>(representative_.size());
  const EdgeList edges(count, [&](const auto& visit) { forEachEdge(faces, representative_, visit); });
  offsets_.assign(representative_.size() + 1, 0);
  edges.forEach([&](Index low, Index high, Index) {
    ++offsets_[low + 1];
    ++offsets_[high + 1];
  });
  std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
  neighbours_.resize(static_cast<std::size_t>(offsets_.back()));
  // A vertex meets its lower neighbours first, in their order, and when its turn comes the higher ones.
  std::vector<Index> next(offsets_.begin(), offsets_.end() - 1);
  edges.forEach([&](Index low, Index high, Index) {
    neighbours_[next[low]++] = high;
    neighbours_[next[high]++] = low;
  });
}

void SurfaceGraph::numberComponents() {
  const std::size_t count = representative_.size();
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
