#include "core/mesh/topology.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace pbffd {
namespace {

/// Silences OpenMesh, which reports on the error stream every face that it cannot hold.
class Silence {
 public:
  Silence() : wasEnabled_(omerr().is_enabled()) { omerr().disable(); }
  ~Silence() {
    if (wasEnabled_) {
      omerr().enable();
    }
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  bool wasEnabled_;
};

/// Half-edges of every face. A half-edge mesh cannot hold all meshes (edges of three faces, fans that meet
/// in one vertex, faces turned over): such a face gets vertices of its own, and `original` tells whose they
/// are, so that counts are still those of the mesh.
class HalfEdges {
 public:
  explicit HalfEdges(const Mesh& mesh) : isCopied_(static_cast<std::size_t>(mesh.vertexCount()), false) {
    const auto faces = static_cast<std::size_t>(mesh.faces.size());
    kernel_.reserve(isCopied_.size(), faces * 2, faces);
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      addVertex(v);
    }
    const Silence silence;
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      addFace(mesh.faces[f]);
    }
  }

  const OpenMesh::PolyConnectivity& kernel() const { return kernel_; }
  Index original(OpenMesh::VertexHandle vertex) const { return original_[vertex.idx()]; }
  bool isCopied(Index vertex) const { return isCopied_[vertex]; }

 private:
  OpenMesh::VertexHandle addVertex(Index original) {
    original_.push_back(original);
    return kernel_.new_vertex();
  }

  void addFace(std::span<const Index> face) {
    corners_.clear();
    for (const Index vertex : face) {
      if (std::find(corners_.begin(), corners_.end(), OpenMesh::VertexHandle(vertex)) == corners_.end()) {
        corners_.emplace_back(vertex);
      }
    }
    if (corners_.size() < 3 || kernel_.add_face(corners_).is_valid()) {
      return;
    }
    for (auto& corner : corners_) {
      isCopied_[corner.idx()] = true;
      corner = addVertex(corner.idx());
    }
    kernel_.add_face(corners_);
  }

  /// Connectivity with storage for it and nothing more.
  class Kernel : public OpenMesh::PolyConnectivity {
   public:
    OpenMesh::VertexHandle new_vertex() { return PolyConnectivity::new_vertex(); }
  };

  Kernel kernel_;
  std::vector<Index> original_;
  std::vector<bool> isCopied_;
  std::vector<OpenMesh::VertexHandle> corners_;
};

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

/// An edge of the mesh and how many faces it has.
struct EdgeUse {
  Index a;
  Index b;
  int faces;
};

std::vector<EdgeUse> edgesOf(const HalfEdges& halfEdges) {
  const auto& kernel = halfEdges.kernel();
  std::vector<EdgeUse> edges;
  edges.reserve(kernel.n_edges());
  std::map<std::pair<Index, Index>, int> copied;
  for (const auto edge : kernel.edges()) {
    const auto half = kernel.halfedge_handle(edge, 0);
    const Index from = halfEdges.original(kernel.from_vertex_handle(half));
    const Index to = halfEdges.original(kernel.to_vertex_handle(half));
    const auto [a, b] = std::minmax(from, to);
    const int faces = kernel.is_boundary(edge) ? 1 : 2;
    if (halfEdges.isCopied(a) && halfEdges.isCopied(b)) {
      copied[{a, b}] += faces;
    } else {
      edges.push_back({a, b, faces});
    }
  }
  for (const auto& [ends, faces] : copied) {
    edges.push_back({ends.first, ends.second, faces});
  }
  return edges;
}

/// Numbers the components by their lowest vertex; -1 for isolated vertices.
std::vector<Index> numberComponents(const Mesh& mesh, Sets& sets, Index& count) {
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
  const HalfEdges halfEdges(mesh);
  const std::vector<EdgeUse> edges = edgesOf(halfEdges);
  Sets sets(mesh.vertexCount());
  for (const EdgeUse& edge : edges) {
    sets.join(edge.a, edge.b);
  }
  Topology topology;
  const std::vector<Index> component = numberComponents(mesh, sets, topology.components);
  topology.isolatedVertices = static_cast<Index>(std::count(component.begin(), component.end(), -1));
  topology.isComponentClosed.assign(static_cast<std::size_t>(topology.components), true);
  for (const EdgeUse& edge : edges) {
    topology.boundaryEdges += edge.faces == 1;
    topology.nonmanifoldEdges += edge.faces > 2;
    if (edge.faces != 2) {
      topology.isComponentClosed[component[edge.a]] = false;
    }
  }
  topology.componentOfFace.reserve(static_cast<std::size_t>(mesh.faces.size()));
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto face = mesh.faces[f];
    topology.componentOfFace.push_back(face.empty() ? -1 : component[face[0]]);
  }
  topology.isClosed = !edges.empty() && topology.boundaryEdges == 0 && topology.nonmanifoldEdges == 0;
  return topology;
}

}  // namespace pbffd
