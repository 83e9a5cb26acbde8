#include "core/mesh/rest_mesh.h"

#include "core/mesh/morton.h"

#include <mutex>
#include <optional>
#include <utility>

namespace pbffd {
namespace {

/// A value made when first asked for, by whichever thread comes first.
template <class Value>
class Lazy {
 public:
  template <class Make>
  const Value& get(Make&& make) {
    std::call_once(once_, [&] { value_.emplace(make()); });
    return *value_;
  }

 private:
  std::once_flag once_;
  std::optional<Value> value_;
};

}  // namespace

struct RestMesh::Derived {
  Lazy<Triangles> triangles;
  Lazy<Points> normals;
  Lazy<Topology> topology;
  Lazy<SurfaceGraph> graph;
  Lazy<BlockGraph> blockGraph;
  Lazy<NearestPoints> nearest;
  Lazy<std::vector<Index>> order;
};

RestMesh::RestMesh(Mesh mesh)
    : mesh_(std::move(mesh)), bounds_(boundsOf(mesh_.positions)), derived_(std::make_unique<Derived>()) {}
RestMesh::~RestMesh() = default;

const Triangles& RestMesh::triangles() const {
  return derived_->triangles.get([&] { return triangulate(mesh_.positions, mesh_.faces); });
}

const Points& RestMesh::normals() const {
  return derived_->normals.get([&] { return vertexNormals(mesh_.positions, triangles()); });
}

const Topology& RestMesh::topology() const {
  return derived_->topology.get([&] { return topologyOf(mesh_); });
}

const SurfaceGraph& RestMesh::graph() const {
  return derived_->graph.get([&] { return SurfaceGraph(mesh_); });
}

const BlockGraph& RestMesh::blockGraph() const {
  return derived_->blockGraph.get([&] { return BlockGraph(graph(), mortonOrder()); });
}

const NearestPoints& RestMesh::nearestVertex() const {
  return derived_->nearest.get([&] { return NearestPoints(mesh_.positions); });
}

const std::vector<Index>& RestMesh::mortonOrder() const {
  return derived_->order.get([&] { return mortonOrderOf(mesh_.positions, bounds_); });
}

}  // namespace pbffd
