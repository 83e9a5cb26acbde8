#include "core/mesh/vertex_clusters.h"

#include "core/base/parallel.h"
#include "core/base/pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

namespace pbffd {
namespace {

constexpr std::size_t grain = 4096;
/// How much nearness to the middle of a cluster counts beside nearness to its planes: where those leave it
/// open.
constexpr double middleShare = 1e-3;

Index rootOf(std::vector<Index>& parent, Index vertex) {
  while (parent[vertex] != vertex) {
    parent[vertex] = parent[parent[vertex]];
    vertex = parent[vertex];
  }
  return vertex;
}

}  // namespace

/// The sum of areas times squared distances from planes, and from the middle.
struct VertexClusters::Error {
  Mat3 normals = Mat3::Zero();  ///< sum area n n^T
  Vec3 offsets = Vec3::Zero();  ///< sum area d n, for planes n v = d
  double area = 0.0;
  Vec3 middle = Vec3::Zero();

  /// Up to a constant.
  double at(const Vec3& v) const {
    return v.dot(normals * v) - 2.0 * v.dot(offsets) + middleShare * area * (v - middle).squaredNorm();
  }
};

VertexClusters::VertexClusters(const RestMesh& mesh, double side, Rule rule, const Progress& progress)
    : mesh_(mesh), clusterOfVertex_(static_cast<std::size_t>(mesh.vertexCount()), -1) {
  if (rule == Rule::connected) {
    joinConnected(side, progress);
  } else {
    joinCells(side, progress);
  }
}

void VertexClusters::joinConnected(double side, const Progress& progress) {
  const SurfaceGraph& graph = mesh_.graph();
  const std::vector<std::uint64_t> cell = cells(side);
  std::vector<Index> parent(clusterOfVertex_.size());
  forEachIn(mesh_.vertexCount(), progress, [&](Index v) {
    parent[v] = graph.representative(v);
    if (parent[v] != v) {
      return;
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
  });
  forEachIn(mesh_.vertexCount(), progress, [&](Index v) {
    Index& ofRoot = clusterOfVertex_[rootOf(parent, v)];
    if (ofRoot < 0) {
      ofRoot = count_++;
    }
    clusterOfVertex_[v] = ofRoot;
  });
}

void VertexClusters::joinCells(double side, const Progress& progress) {
  const std::vector<std::uint64_t> cell = cells(side);
  std::vector<std::uint64_t> taken = cell;
  progress.throwIfCancelled();
  parallelSort(taken);
  progress.throwIfCancelled();
  taken.erase(std::unique(taken.begin(), taken.end()), taken.end());
  count_ = static_cast<Index>(taken.size());
  forEachIn(mesh_.vertexCount(), progress, [&](Index v) {
    const auto at = std::lower_bound(taken.begin(), taken.end(), cell[v]);
    clusterOfVertex_[v] = static_cast<Index>(at - taken.begin());
  });
}

std::vector<std::uint64_t> VertexClusters::cells(double side) const {
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

VertexClusters::Corners VertexClusters::clustersOf(Index triangle) const {
  const Index* const corner = cornersOf(triangle);
  return {clusterOfVertex_[corner[0]], clusterOfVertex_[corner[1]], clusterOfVertex_[corner[2]]};
}

std::vector<VertexClusters::Corners> VertexClusters::triangles(const Progress& progress) const {
  struct Found {
    Corners sorted;
    Index triangle;
    bool operator<(const Found& other) const {
      return std::tie(sorted, triangle) < std::tie(other.sorted, other.triangle);
    }
  };
  std::vector<Found> found;
  forEachIn(mesh_.triangles().size(), progress, [&](Index t) {
    Corners corners = clustersOf(t);
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) {
      std::sort(corners.begin(), corners.end());
      found.push_back({corners, t});
    }
  });
  parallelSort(found);
  progress.throwIfCancelled();
  const auto isSame = [](const Found& a, const Found& b) { return a.sorted == b.sorted; };
  found.erase(std::unique(found.begin(), found.end(), isSame), found.end());
  std::vector<Index> firsts(found.size());
  std::transform(found.begin(), found.end(), firsts.begin(), [](const Found& each) { return each.triangle; });
  parallelSort(firsts);
  progress.throwIfCancelled();
  std::vector<Corners> triangles(firsts.size());
  std::transform(firsts.begin(), firsts.end(), triangles.begin(), [&](Index t) { return clustersOf(t); });
  return triangles;
}

std::vector<VertexClusters::Error> VertexClusters::errors(const Progress& progress) const {
  std::vector<Error> errors(static_cast<std::size_t>(count_));
  std::vector<Index> members(errors.size(), 0);
  forEachIn(mesh_.vertexCount(), progress, [&](Index v) {
    errors[clusterOfVertex_[v]].middle += position(v);
    ++members[clusterOfVertex_[v]];
  });
  for (std::size_t c = 0; c < errors.size(); ++c) {
    errors[c].middle /= members[c];
  }
  forEachIn(mesh_.triangles().size(), progress, [&](Index t) {
    const Index* const corner = cornersOf(t);
    const Vec3 first = position(corner[0]);
    const Vec3 across = (position(corner[1]) - first).cross(position(corner[2]) - first);
    const double area = across.norm();
    if (!(area > 0.0)) {
      return;
    }
    const Vec3 normal = across / area;
    for (const Index cluster : clustersOf(t)) {
      Error& error = errors[cluster];
      error.normals += area * normal * normal.transpose();
      error.offsets += area * normal.dot(first) * normal;
      error.area += area;
    }
  });
  return errors;
}

std::vector<Index> VertexClusters::standIns(const Progress& progress) const {
  const std::vector<Error> errors = this->errors(progress);
  std::vector<Index> best(errors.size(), -1);
  std::vector<double> least(errors.size(), std::numeric_limits<double>::infinity());
  forEachIn(mesh_.vertexCount(), progress, [&](Index v) {
    const Index cluster = clusterOfVertex_[v];
    const double error = errors[cluster].at(position(v));
    if (best[cluster] < 0 || error < least[cluster]) {
      best[cluster] = v;
      least[cluster] = error;
    }
  });
  return best;
}

double VertexClusters::vanishedArea(const Progress& progress) const {
  std::vector<bool> isLeft(static_cast<std::size_t>(count_), false);
  std::vector<double> areas(isLeft.size(), 0.0);
  forEachIn(mesh_.triangles().size(), progress, [&](Index t) {
    const Corners clusters = clustersOf(t);
    if (clusters[0] == clusters[1] && clusters[1] == clusters[2]) {
      const Index* const corner = cornersOf(t);
      const Vec3 first = position(corner[0]);
      areas[clusters[0]] += 0.5 * (position(corner[1]) - first).cross(position(corner[2]) - first).norm();
      return;
    }
    for (const Index cluster : clusters) {
      isLeft[cluster] = true;
    }
  });
  double vanished = 0.0;
  for (std::size_t c = 0; c < areas.size(); ++c) {
    vanished += isLeft[c] ? 0.0 : areas[c];
  }
  return vanished;
}

}  // namespace pbffd
