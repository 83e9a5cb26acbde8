#include "core/mesh/topology.h"

#include "core/mesh/edge_list.h"

#include <algorithm>
#include <numeric>

namespace pbffd {
namespace {

/// Calls visit(corners) for every face of three corners or more, each vertex in it once.
template <class Visit>
void forEachFace(const Polygons& faces, const Visit& visit) {
  std::vector<Index> corners;
  for (Index f = 0; f < faces.size(); ++f) {
    corners.clear();
    for (const Index vertex : faces[f]) {
      if (std::find(corners.begin(), corners.end(), vertex) == corners.end()) {
        corners.push_back(vertex);
      }
    }
    if (corners.size() >= 3) {
      visit(corners);
    }
  }
}

/// Calls visit(a, b) for every edge of every face.
template <class Visit>
void forEachEdge(const Polygons& faces, const Visit& visit) {
  forEachFace(faces, [&](const std::vector<Index>& corners) {
    Index before = corners.back();
    for (const Index vertex : corners) {
      visit(before, vertex);
      before = vertex;
    }
  });
}

/// Disjoint sets of vertices.
class Sets {
 public:
  explicit Sets(Index count) : parent_(static_cast<std::size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  Index find(Index vertex) {
    while (parent_[vertex] != vertex) {
      parent_[vertex] = parent_[parent_[vertex]];
      vertex = parent_[vertex];
    }
    return vertex;
  }
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

/// Numbers the components by their lowest vertex; -1 for isolated vertices.
std::vector<Index> numberComponents(const Mesh& mesh, Index& count) {
  Sets sets(mesh.vertexCount());
  forEachFace(mesh.faces, [&](const std::vector<Index>& corners) {
    for (const Index vertex : corners) {
      sets.join(corners[0], vertex);
    }
  });
  std::vector<Index> number(static_cast<std::size_t>(mesh.vertexCount()), -1);
  std::vector<bool> isUsed(number.size(), false);
  for (const Index vertex : mesh.faces.vertices()) {
    isUsed[vertex] = true;
  }
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (isUsed[v]) {
      Index& root = number[sets.find(v)];
      if (root < 0) {
        root = count++;
      }
      number[v] = root;
    }
  }
  return number;
}

}  // namespace

Topology topologyOf(const Mesh& mesh) {
  Topology topology;
  const std::vector<Index> component = numberComponents(mesh, topology.components);
  topology.isolatedVertices = static_cast<Index>(std::count(component.begin(), component.end(), -1));
  topology.isComponentClosed.assign(static_cast<std::size_t>(topology.components), true);
  bool hasEdges = false;
  const EdgeList edges(mesh.vertexCount(), [&](const auto& visit) { forEachEdge(mesh.faces, visit); });
  edges.forEach([&](Index vertex, Index, Index faces) {
    hasEdges = true;
    topology.boundaryEdges += faces == 1;
    topology.nonmanifoldEdges += faces > 2;
    if (faces != 2) {
      topology.isComponentClosed[component[vertex]] = false;
    }
  });
  topology.componentOfFace.reserve(static_cast<std::size_t>(mesh.faces.size()));
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto face = mesh.faces[f];
    topology.componentOfFace.push_back(face.empty() ? -1 : component[face[0]]);
  }
  topology.isClosed = hasEdges && topology.boundaryEdges == 0 && topology.nonmanifoldEdges == 0;
  return topology;
}

}  // namespace pbffd
