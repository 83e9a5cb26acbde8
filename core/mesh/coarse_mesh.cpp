#include "core/mesh/coarse_mesh.h"

#include "core/base/parallel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

namespace pbffd {
namespace {

constexpr std::size_t grain = 4096;
/// A grid is good enough when it gives more than this share of the triangles allowed.
constexpr double leastShare = 0.7;
constexpr int mostGrids = 10;
/// A surface of area 1 meets about 1.5 cells of side 1, and has two triangles a vertex.
constexpr double trianglesPerCellArea = 3.0;
/// Cells are numbered in 21 bits along each axis.
constexpr double leastSide = 1e-6;
/// How much nearness to the middle of a cluster counts beside nearness to its planes: where those leave it
/// open.
constexpr double middleShare = 1e-3;

using Corners = std::array<Index, 3>;

/// The sum of areas times squared distances from planes, and from the middle.
struct ClusterError {
  Mat3 normals = Mat3::Zero();  ///< sum area n n^T
  Vec3 offsets = Vec3::Zero();  ///< sum area d n, for planes n v = d
  double area = 0.0;
  Vec3 middle = Vec3::Zero();

  /// Up to a constant.
  double at(const Vec3& v) const {
    return v.dot(normals * v) - 2.0 * v.dot(offsets) + middleShare * area * (v - middle).squaredNorm();
  }
};

class Clustering {
 public:
  Clustering(const RestMesh& mesh, double side);

  /// The triangles between three clusters, each triple once, in the order and the turn of the first of the
  /// mesh.
  std::vector<Corners> triangles() const;
  /// The vertex that stands for each cluster.
  std::vector<Index> standIns() const;

 private:
  std::vector<std::uint64_t> cells(double side) const;
  Corners clustersOf(Index triangle) const;
  std::vector<ClusterError> errors() const;
  /// Relative to the middle of the mesh, so that nothing is lost far from the origin.
  Vec3 position(Index vertex) const {
    return mesh_.positions().row(vertex).transpose() - mesh_.bounds().center();
  }

  const RestMesh& mesh_;
  std::vector<Index> clusterOfVertex_;
  Index count_ = 0;
};

Index rootOf(std::vector<Index>& parent, Index vertex) {
  while (parent[vertex] != vertex) {
    parent[vertex] = parent[parent[vertex]];
    vertex = parent[vertex];
  }
  return vertex;
}

Clustering::Clustering(const RestMesh& mesh, double side)
    : mesh_(mesh), clusterOfVertex_(static_cast<std::size_t>(mesh.vertexCount()), -1) {
  const SurfaceGraph& graph = mesh.graph();
  const std::vector<std::uint64_t> cell = cells(side);
  std::vector<Index> parent(clusterOfVertex_.size());
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    parent[v] = graph.representative(v);
    if (parent[v] != v) {
      continue;
    }
    for (const Index before : graph.neighbours(v)) {
      if (before > v) {
        break;
      }
      if (cell[before] == cell[v]) {
        const Index a = rootOf(parent, before);
        const Index b = rootOf(parent, v);
        parent[std::max(a, b)] = std::min(a, b);
      }
    }
  }
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    Index& ofRoot = clusterOfVertex_[rootOf(parent, v)];
    if (ofRoot < 0) {
      ofRoot = count_++;
    }
    clusterOfVertex_[v] = ofRoot;
  }
}

std::vector<std::uint64_t> Clustering::cells(double side) const {
  std::vector<std::uint64_t> cells(clusterOfVertex_.size());
  const Vec3 low = mesh_.bounds().low;
  parallelFor(cells.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Vec3 at = (mesh_.positions().row(static_cast<Index>(v)).transpose() - low) / side;
      cells[v] = static_cast<std::uint64_t>(at[0]) << 42 | static_cast<std::uint64_t>(at[1]) << 21 |
                 static_cast<std::uint64_t>(at[2]);
    }
  });
  return cells;
}

Corners Clustering::clustersOf(Index triangle) const {
  const Index* const corner = &mesh_.triangles().vertices[3 * static_cast<std::size_t>(triangle)];
  return {clusterOfVertex_[corner[0]], clusterOfVertex_[corner[1]], clusterOfVertex_[corner[2]]};
}

std::vector<Corners> Clustering::triangles() const {
  struct Found {
    Corners sorted;
    Index triangle;
    bool operator<(const Found& other) const {
      return std::tie(sorted, triangle) < std::tie(other.sorted, other.triangle);
    }
  };
  std::vector<Found> found;
  for (Index t = 0; t < mesh_.triangles().size(); ++t) {
    Corners corners = clustersOf(t);
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
      std::sort(corners.begin(), corners.end());
      found.push_back({corners, t});
    }
  }
  std::sort(found.begin(), found.end());
  const auto isSame = [](const Found& a, const Found& b) { return a.sorted == b.sorted; };
  found.erase(std::unique(found.begin(), found.end(), isSame), found.end());
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.triangle < b.triangle; });
  std::vector<Corners> triangles(found.size());
  std::transform(found.begin(), found.end(), triangles.begin(),
                 [&](const Found& each) { return clustersOf(each.triangle); });
  return triangles;
}

std::vector<ClusterError> Clustering::errors() const {
  std::vector<ClusterError> errors(static_cast<std::size_t>(count_));
  std::vector<Index> members(errors.size(), 0);
  for (Index v = 0; v < mesh_.vertexCount(); ++v) {
    errors[clusterOfVertex_[v]].middle += position(v);
    ++members[clusterOfVertex_[v]];
  }
  for (std::size_t c = 0; c < errors.size(); ++c) {
    errors[c].middle /= members[c];
  }
  for (Index t = 0; t < mesh_.triangles().size(); ++t) {
    const Index* const corner = &mesh_.triangles().vertices[3 * static_cast<std::size_t>(t)];
    const Vec3 first = position(corner[0]);
    const Vec3 across = (position(corner[1]) - first).cross(position(corner[2]) - first);
    const double area = across.norm();
    if (!(area > 0.0)) {
      continue;
    }
    const Vec3 normal = across / area;
    for (const Index cluster : clustersOf(t)) {
      ClusterError& error = errors[cluster];
      error.normals += area * normal * normal.transpose();
      error.offsets += area * normal.dot(first) * normal;
      error.area += area;
    }
  }
  return errors;
}

std::vector<Index> Clustering::standIns() const {
  const std::vector<ClusterError> errors = this->errors();
  std::vector<Index> best(errors.size(), -1);
  std::vector<double> least(errors.size(), std::numeric_limits<double>::infinity());
  for (Index v = 0; v < mesh_.vertexCount(); ++v) {
    const Index cluster = clusterOfVertex_[v];
    const double error = errors[cluster].at(position(v));
    if (best[cluster] < 0 || error < least[cluster]) {
      best[cluster] = v;
      least[cluster] = error;
    }
  }
  return best;
}

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
CoarseMesh compact(const RestMesh& mesh, std::vector<Index> corners) {
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
  for (Index& corner : corners) {
    corner = place[corner];
  }
  coarse.triangles = std::move(corners);
  return coarse;
}

double areaOf(const RestMesh& mesh) {
  double sum = 0.0;
  const std::vector<Index>& corners = mesh.triangles().vertices;
  for (std::size_t c = 0; c < corners.size(); c += 3) {
    const Vec3 first = mesh.positions().row(corners[c]);
    const Vec3 second = mesh.positions().row(corners[c + 1]);
    const Vec3 third = mesh.positions().row(corners[c + 2]);
    sum += 0.5 * (second - first).cross(third - first).norm();
  }
  return sum;
}

/// The finest grid found that gives few enough triangles, by the law of a smooth surface and bisection.
struct FoundGrid {
  std::unique_ptr<const Clustering> clustering;
  std::vector<Corners> triangles;
};

FoundGrid findGrid(const RestMesh& mesh, Index most, const Progress& progress) {
  const double smallest = leastSide * std::max(mesh.diagonal(), std::numeric_limits<double>::min());
  double side = std::max(smallest, std::sqrt(trianglesPerCellArea * areaOf(mesh) / most));
  double tooSmall = 0.0;
  double largeEnough = std::numeric_limits<double>::infinity();
  FoundGrid found;
  for (int grid = 0; grid < mostGrids || found.clustering == nullptr; ++grid) {
    progress.throwIfCancelled();
    auto clustering = std::make_unique<const Clustering>(mesh, side);
    std::vector<Corners> triangles = clustering->triangles();
    const double share = static_cast<double>(triangles.size()) / most;
    if (share <= 1.0) {
      largeEnough = side;
      found = {std::move(clustering), std::move(triangles)};
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
      side = found.clustering == nullptr ? 1.25 * side : 0.5 * (tooSmall + largeEnough);
    }
    side = std::max(smallest, side);
  }
  return found;
}

}  // namespace

CoarseMesh coarseMesh(const RestMesh& mesh, Index mostTriangles, const Progress& progress) {
  const Index most = std::max<Index>(mostTriangles, 1);
  if (mesh.triangles().size() <= most) {
    return compact(mesh, mesh.triangles().vertices);
  }
  const FoundGrid found = findGrid(mesh, most, progress);
  const std::vector<Index> standIns = found.clustering->standIns();
  std::vector<Index> corners;
  corners.reserve(3 * found.triangles.size());
  for (const Corners& triangle : found.triangles) {
    const Corners vertices{standIns[triangle[0]], standIns[triangle[1]], standIns[triangle[2]]};
    const bool isFolded = isTurnedAgainstItsVertices(mesh, vertices);
    corners.insert(corners.end(), {vertices[0], vertices[isFolded ? 2 : 1], vertices[isFolded ? 1 : 2]});
  }
  return compact(mesh, std::move(corners));
}

}  // namespace pbffd
