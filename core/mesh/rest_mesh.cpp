#include "core/mesh/rest_mesh.h"

#include "core/base/lazy.h"
#include "core/mesh/morton.h"

#include <utility>

namespace pbffd {

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
  return derived_->nearest.get([&] { return NearestPoints::over(mesh_.positions); });
}

const std::vector<Index>& RestMesh::mortonOrder() const {
  return derived_->order.get([&] { return mortonOrderOf(mesh_.positions, bounds_); });
}

}  // namespace pbffd
