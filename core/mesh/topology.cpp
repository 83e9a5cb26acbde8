#include "core/mesh/topology.h"

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace pbffd {
namespace {

/// Silences OpenMesh, which reports on the error stream every face that it cannot hold. Once and for good: its
/// stream is one for all threads.
void silenceOpenMesh() {
  static const bool isSilent = [] {
    omerr().disable();
    return true;
  }();
  static_cast<void>(isSilent);
}

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
    silenceOpenMesh();
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

/// The edges of the mesh, read off its half-edges.
class Edges {
 public:
  explicit Edges(const HalfEdges& halfEdges) : halfEdges_(halfEdges) {
    forEachOfKernel([&](Index a, Index b, int faces) {
      if (isCopied(a, b)) {
        copied_[{a, b}] += faces;
      }
    });
  }

  /// Calls visit(a, b, faces) once for each edge, a <= b, with how many faces it has.
  template <class Visit>
  void forEach(const Visit& visit) const {
    forEachOfKernel([&](Index a, Index b, int faces) {
      if (!isCopied(a, b)) {
        visit(a, b, faces);
      }
    });
    for (const auto& [ends, faces] : copied_) {
      visit(ends.first, ends.second, faces);
    }
  }

 private:
  bool isCopied(Index a, Index b) const { return halfEdges_.isCopied(a) && halfEdges_.isCopied(b); }

  template <class Visit>
  void forEachOfKernel(const Visit& visit) const {
    const auto& kernel = halfEdges_.kernel();
    for (const auto edge : kernel.edges()) {
      const auto half = kernel.halfedge_handle(edge, 0);
      const Index from = halfEdges_.original(kernel.from_vertex_handle(half));
      const Index to = halfEdges_.original(kernel.to_vertex_handle(half));
      visit(std::min(from, to), std::max(from, to), kernel.is_boundary(edge) ? 1 : 2);
    }
  }

  const HalfEdges& halfEdges_;
  std::map<std::pair<Index, Index>, int> copied_;  ///< the faces of edges between vertices that have copies
};

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
  const Edges edges(halfEdges);
  Sets sets(mesh.vertexCount());
  edges.forEach([&](Index a, Index b, int) { sets.join(a, b); });
  Topology topology;
  const std::vector<Index> component = numberComponents(mesh, sets, topology.components);
  topology.isolatedVertices = static_cast<Index>(std::count(component.begin(), component.end(), -1));
  topology.isComponentClosed.assign(static_cast<std::size_t>(topology.components), true);
  bool hasEdges = false;
  edges.forEach([&](Index a, Index, int faces) {
    hasEdges = true;
    topology.boundaryEdges += faces == 1;
    topology.nonmanifoldEdges += faces > 2;
    if (faces != 2) {
      topology.isComponentClosed[component[a]] = false;
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
