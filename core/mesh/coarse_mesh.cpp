#include "core/mesh/coarse_mesh.h"

#include "core/base/pieces.h"
#include "core/mesh/vertex_clusters.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace pbffd {
namespace {

/// A grid is good enough when it gives more than this share of the triangles allowed.
constexpr double leastShare = 0.7;
constexpr int mostGrids = 10;
/// A surface of area 1 meets about 1.5 cells of side 1, and has two triangles a vertex.
constexpr double trianglesPerCellArea = 3.0;
/// Cells are numbered in 21 bits along each axis.
constexpr double leastSide = 1e-6;
/// Where a larger share of the area than this would vanish, in parts smaller than the cells, they are joined.
constexpr double mostVanished = 0.1;

using Corners = VertexClusters::Corners;

/// A triangle may be turned over where the vertices that stand for its clusters lie in another order than the
/// clusters do: it would be seen from behind, as a dark speck.
bool isTurnedAgainstItsVertices(const RestMesh& mesh, const Corners& corners) {
  const Vec3 first = mesh.positions().row(corners[0]);
  const Vec3 across = (mesh.positions().row(corners[1]).transpose() - first)
                          .cross(mesh.positions().row(corners[2]).transpose() - first);
  Vec3 normals = Vec3::Zero();
  for (const Index corner : corners) {
    normals += mesh.normals().row(corner);
  }
  return across.dot(normals) < 0.0;
}

/// The vertices that are used, and the corners by their places among them.
CoarseMesh compact(const RestMesh& mesh, std::span<const Index> corners) {
  std::vector<Index> place(static_cast<std::size_t>(mesh.vertexCount()), -1);
  for (const Index vertex : corners) {
    place[vertex] = 0;
  }
  CoarseMesh coarse;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (place[v] == 0) {
      place[v] = static_cast<Index>(coarse.vertices.size());
      coarse.vertices.push_back(v);
    }
  }
  coarse.triangles.resize(corners.size());
  std::transform(corners.begin(), corners.end(), coarse.triangles.begin(),
                 [&](Index vertex) { return place[vertex]; });
  return coarse;
}

double areaOf(const RestMesh& mesh, const Progress& progress) {
  double sum = 0.0;
  const std::span<const Index> corners = mesh.triangles().vertices();
  forEachIn(mesh.triangles().size(), progress, [&](Index t) {
    const Index* const corner = &corners[3 * static_cast<std::size_t>(t)];
    const Vec3 first = mesh.positions().row(corner[0]);
    const Vec3 second = mesh.positions().row(corner[1]);
    const Vec3 third = mesh.positions().row(corner[2]);
    sum += 0.5 * (second - first).cross(third - first).norm();
  });
  return sum;
}

struct FoundGrid {
  std::unique_ptr<const VertexClusters> clusters;
  std::vector<Corners> triangles;
};

struct Wanted {
  Index most;  ///< triangles
  VertexClusters::Rule rule;
  double area;  ///< of the mesh
};

/// The finest grid found that gives few enough triangles, by the law of a smooth surface and bisection.
FoundGrid findGrid(const RestMesh& mesh, const Wanted& wanted, const Progress& progress) {
  const double smallest = leastSide * std::max(mesh.diagonal(), std::numeric_limits<double>::min());
  double side = std::max(smallest, std::sqrt(trianglesPerCellArea * wanted.area / wanted.most));
  double tooSmall = 0.0;
  double largeEnough = std::numeric_limits<double>::infinity();
  FoundGrid found;
  for (int grid = 0; grid < mostGrids || found.clusters == nullptr; ++grid) {
    auto clusters = std::make_unique<const VertexClusters>(mesh, side, wanted.rule, progress);
    std::vector<Corners> triangles = clusters->triangles(progress);
    const double share = static_cast<double>(triangles.size()) / wanted.most;
    if (share <= 1.0) {
      largeEnough = side;
      found = {std::move(clusters), std::move(triangles)};
    } else {
      tooSmall = side;
    }
    if (share <= 1.0 && (share >= leastShare || side <= smallest)) {
      break;
    }
    const double guess = side * std::sqrt(share / (0.5 * (1.0 + leastShare)));
    if (guess > tooSmall && guess < largeEnough) {
      side = guess;
    } else {
      side = found.clusters == nullptr ? 1.25 * side : 0.5 * (tooSmall + largeEnough);
    }
    side = std::max(smallest, side);
  }
  return found;
}

FoundGrid findGrid(const RestMesh& mesh, Index most, const Progress& progress) {
  const double area = areaOf(mesh, progress);
  FoundGrid found = findGrid(mesh, {most, VertexClusters::Rule::connected, area}, progress);
  if (found.clusters->vanishedArea(progress) > mostVanished * area) {
    found = findGrid(mesh, {most, VertexClusters::Rule::cells, area}, progress);
  }
  return found;
}

}  // namespace

CoarseMesh coarseMesh(const RestMesh& mesh, Index mostTriangles, const Progress& progress) {
  const Index most = std::max<Index>(mostTriangles, 1);
  if (mesh.triangles().size() <= most) {
    return compact(mesh, mesh.triangles().vertices());
  }
  const FoundGrid found = findGrid(mesh, most, progress);
  const std::vector<Index> standIns = found.clusters->standIns(progress);
  std::vector<Index> corners;
  corners.reserve(3 * found.triangles.size());
  for (const Corners& triangle : found.triangles) {
    const Corners vertices{standIns[triangle[0]], standIns[triangle[1]], standIns[triangle[2]]};
    const bool isFolded = isTurnedAgainstItsVertices(mesh, vertices);
    corners.insert(corners.end(), {vertices[0], vertices[isFolded ? 2 : 1], vertices[isFolded ? 1 : 2]});
  }
  return compact(mesh, corners);
}

}  // namespace pbffd
