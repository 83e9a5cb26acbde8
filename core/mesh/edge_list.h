#pragma once

#include "core/base/parallel.h"
#include "core/base/types.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace pbffd {

/// The edges of a mesh, each at its lower vertex: plain lists, which hold every mesh as it is (edges of three
/// faces, fans that meet in a vertex, faces turned over).
class EdgeList {
 public:
  /// forEachEdge(visit) calls visit(a, b) for every edge of every face, in the same order each time.
  template <class ForEachEdge>
  EdgeList(Index vertexCount, const ForEachEdge& forEachEdge)
      : start_(static_cast<std::size_t>(vertexCount) + 1, 0) {
    forEachEdge([&](Index a, Index b) { ++start_[std::min(a, b) + 1]; });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    ends_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<Index> next(start_.begin(), start_.end() - 1);
    forEachEdge([&](Index a, Index b) { ends_[next[std::min(a, b)]++] = std::max(a, b); });
    parallelFor(next.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        std::sort(ends_.begin() + start_[v], ends_.begin() + start_[v + 1]);
      }
    });
  }

  /// Calls visit(low, high, faces) once for every edge, with its vertices and how many faces have it; ascending
  /// by the lower vertex, then by the higher one.
  template <class Visit>
  void forEach(const Visit& visit) const {
    for (std::size_t v = 0; v + 1 < start_.size(); ++v) {
      for (Index at = start_[v], next = at; at < start_[v + 1]; at = next) {
        while (next < start_[v + 1] && ends_[next] == ends_[at]) {
          ++next;
        }
        visit(static_cast<Index>(v), ends_[at], next - at);
      }
    }
  }

 private:
  std::vector<Index> start_;  ///< V + 1 entries
  std::vector<Index> ends_;   ///< the higher vertices, one for each face at the edge
};

}  // namespace pbffd
