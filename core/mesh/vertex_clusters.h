#pragma once

#include "core/base/progress.h"
#include "core/mesh/rest_mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pbffd {

/// The vertices of a mesh clustered by the cells of a grid (Rossignac and Borrel).
class VertexClusters {
 public:
  enum class Rule {
    connected,  ///< only what hangs together within a cell: the sides of a thin wall stay two
    cells,      ///< all that is in a cell: parts smaller than a cell join their neighbours
  };
  /// Cells of this side, of which at most 2^21 may lie along an axis. The mesh must live longer. This and all
  /// that takes a Progress throws Cancelled.
  VertexClusters(const RestMesh& mesh, double side, Rule rule, const Progress& progress);

  using Corners = std::array<Index, 3>;
  /// The triangles between three clusters, each triple once, in the order and the turn of the first of the
  /// mesh.
  std::vector<Corners> triangles(const Progress& progress) const;
  /// The vertex that stands for each cluster: the nearest to the planes of the triangles around.
  std::vector<Index> standIns(const Progress& progress) const;
  /// The area of all parts of the mesh that lie within one cluster each, of which nothing is left.
  double vanishedArea(const Progress& progress) const;

 private:
  struct Error;
  std::vector<std::uint64_t> cells(double side) const;
  void joinConnected(double side, const Progress& progress);
  void joinCells(double side, const Progress& progress);
  const Index* cornersOf(Index triangle) const {
    return &mesh_.triangles().vertices()[3 * static_cast<std::size_t>(triangle)];
  }
  Corners clustersOf(Index triangle) const;
  std::vector<Error> errors(const Progress& progress) const;
  /// Relative to the middle of the mesh, so that nothing is lost far from the origin.
  Vec3 position(Index vertex) const {
    return mesh_.positions().row(vertex).transpose() - mesh_.bounds().center();
  }

  const RestMesh& mesh_;
  std::vector<Index> clusterOfVertex_;
  Index count_ = 0;
};

}  // namespace pbffd
