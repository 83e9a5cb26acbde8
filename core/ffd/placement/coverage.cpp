#include "core/ffd/placement/coverage.h"

#include "core/base/parallel.h"
#include "core/ffd/weights/membership.h"

#include <algorithm>
#include <cmath>

namespace pbffd {
namespace {

/// Where a vertex that was taken in lies between centre and border: the basis is 5 % there.
constexpr double takenInAt = 0.8;

/// So many regions are tried for a vertex before the nearest is grown until it reaches it.
constexpr std::size_t regionsTried = 8;
constexpr double growthOfLastResort = 1.25;

Frame scaled(const Frame& frame, double factor) {
  return {frame.center, factor * frame.axes};
}

class Cover {
 public:
  Cover(std::vector<ControlPoint>& points, const RestMesh& mesh)
      : points_(points),
        mesh_(mesh),
        blocks_(mesh.positions(), mesh.mortonOrder()),
        walks_(mesh.graph(), mesh.vertexCount()),
        isReached_(static_cast<std::size_t>(mesh.vertexCount()), false) {}

  void coverAll(const Progress& progress) {
    growToTouch(progress);
    for (const ControlPoint& point : points_) {
      regions_.emplace_back(point.rest);
    }
    const auto reached = reachedByEach(progress);
    for (const auto& vertices : reached) {
      mark(vertices);
    }
    std::vector<bool> hasFace(isReached_.size(), false);
    for (const Index vertex : mesh_.mesh().faces.vertices()) {
      hasFace[vertex] = true;
    }
    for (std::size_t v = 0; v < isReached_.size(); ++v) {
      if (!isReached_[v] && hasFace[v]) {
        progress.throwIfCancelled();
        takeIn(static_cast<Index>(v));
        result_.uncovered += !isReached_[v];
      }
    }
  }

  const Coverage& result() const { return result_; }

 private:
  /// The vertices that a point counts.
  std::vector<Index> reachedBy(const ControlPoint& point) {
    const std::vector<Index>& order = mesh_.mortonOrder();
    const Region region(point.rest);
    Membership members = pointsInside(blocks_, region);
    if (point.reach == Reach::connected && !members.blocks.empty()) {
      auto walk = walks_.take();
      startWalk(*walk, blocks_, order, region, members);
      members = countedBy(*walk, members, order);
    }
    std::vector<Index> vertices;
    for (std::size_t e = 0; e < members.blocks.size(); ++e) {
      for (Index k = 0; k < PointBlocks::blockSize; ++k) {
        if ((members.members[e] >> k & 1) != 0) {
          vertices.push_back(order[members.blocks[e] * PointBlocks::blockSize + k]);
        }
      }
    }
    return vertices;
  }

  std::vector<std::vector<Index>> reachedByEach(const Progress& progress) {
    std::vector<std::vector<Index>> reached(points_.size());
    parallelFor(points_.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.isCancelled(); ++i) {
        reached[i] = reachedBy(points_[i]);
      }
    });
    progress.throwIfCancelled();
    return reached;
  }

  void growToTouch(const Progress& progress) {
    std::vector<std::uint8_t> hasGrown(points_.size(), 0);
    parallelFor(points_.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.isCancelled(); ++i) {
        const Region region(points_[i].rest);
        if (!pointsInside(blocks_, region).blocks.empty()) {
          continue;
        }
        const Index vertex = mesh_.nearestVertex().nearest(points_[i].rest.center).index;
        if (vertex >= 0) {
          grow(i, std::sqrt(region.squaredDistance(mesh_.positions().row(vertex))) / takenInAt);
          hasGrown[i] = 1;
        }
      }
    });
    progress.throwIfCancelled();
    result_.grown += static_cast<Index>(std::count(hasGrown.begin(), hasGrown.end(), 1));
  }

  void grow(std::size_t point, double factor) {
    points_[point].rest = scaled(points_[point].rest, factor);
    points_[point].pose = points_[point].rest;
  }

  void mark(const std::vector<Index>& vertices) {
    for (const Index vertex : vertices) {
      isReached_[vertex] = true;
    }
  }

  void takeIn(Index vertex) {
    // By what they were at first: one that has grown would else be the nearest to more and more.
    std::vector<std::pair<double, std::size_t>> byDistance;
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      byDistance.emplace_back(regions_[i].squaredDistance(mesh_.positions().row(vertex)), i);
    }
    const std::size_t tried = std::min(regionsTried, byDistance.size());
    std::partial_sort(byDistance.begin(), byDistance.begin() + static_cast<std::ptrdiff_t>(tried),
                      byDistance.end());
    for (std::size_t t = 0; t < tried; ++t) {
      if (growIfItReaches(byDistance[t].second, factorToTakeIn(byDistance[t].second, vertex), vertex)) {
        return;
      }
    }
    // A region that holds the whole mesh reaches all of it.
    const std::size_t nearest = byDistance[0].second;
    for (double factor = factorToTakeIn(nearest, vertex); factor < 1e6; factor *= growthOfLastResort) {
      if (growIfItReaches(nearest, factor, vertex)) {
        return;
      }
    }
  }

  double factorToTakeIn(std::size_t point, Index vertex) const {
    const Region region(points_[point].rest);
    return std::max(1.0, std::sqrt(region.squaredDistance(mesh_.positions().row(vertex))) / takenInAt);
  }

  bool growIfItReaches(std::size_t point, double factor, Index vertex) {
    ControlPoint larger = points_[point];
    larger.rest = scaled(larger.rest, factor);
    larger.pose = larger.rest;
    const std::vector<Index> reached = reachedBy(larger);
    if (std::find(reached.begin(), reached.end(), vertex) == reached.end()) {
      return false;
    }
    points_[point] = larger;
    mark(reached);
    ++result_.grown;
    return true;
  }

  std::vector<ControlPoint>& points_;
  const RestMesh& mesh_;
  std::vector<Region> regions_;  ///< before any vertex was taken in
  PointBlocks blocks_;
  ReachWalks walks_;
  std::vector<bool> isReached_;
  Coverage result_;
};

}  // namespace

Coverage growCoverage(std::vector<ControlPoint>& points, const RestMesh& mesh, const Progress& progress) {
  if (points.empty()) {
    return {};
  }
  Cover cover(points, mesh);
  cover.coverAll(progress);
  return cover.result();
}

}  // namespace pbffd
