#pragma once

#include "core/mesh/block_graph.h"
#include "core/mesh/mesh.h"
#include "core/mesh/nearest.h"
#include "core/mesh/normals.h"
#include "core/mesh/surface_graph.h"
#include "core/mesh/topology.h"

#include <memory>

namespace pbffd {

/// A mesh that no longer changes, with what follows from it alone, each computed when first asked for and
/// kept. Shared by all values of a project. Every member may be called from any thread.
class RestMesh {
 public:
  explicit RestMesh(Mesh mesh);
  ~RestMesh();
  RestMesh(const RestMesh&) = delete;
  RestMesh& operator=(const RestMesh&) = delete;

  const Mesh& mesh() const { return mesh_; }
  const Points& positions() const { return mesh_.positions; }
  Index vertexCount() const { return mesh_.vertexCount(); }
  const Bounds& bounds() const { return bounds_; }
  double diagonal() const { return bounds_.diagonal(); }

  const Triangles& triangles() const;
  const Points& normals() const;
  const Topology& topology() const;
  const SurfaceGraph& graph() const;
  /// graph() over the blocks of 16 of mortonOrder().
  const BlockGraph& blockGraph() const;
  const NearestPoints& nearestVertex() const;

  /// All vertices in Morton order: mortonOrder()[slot] = vertex. What is near in space is near in memory,
  /// so blocks of slots are compact. The order of everything that is drawn.
  const std::vector<Index>& mortonOrder() const;

 private:
  struct Derived;
  Mesh mesh_;
  Bounds bounds_;
  std::unique_ptr<Derived> derived_;
};

}  // namespace pbffd
