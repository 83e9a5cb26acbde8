#include "core/ffd/placement/coverage.h"

#include "core/base/parallel.h"
#include "core/ffd/weights/reach.h"

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
        walks_(mesh),
        isReached_(static_cast<std::size_t>(blocks_.blockCount()), 0) {}

  void coverAll(const Progress& progress) {
    growToTouch(progress);
    for (const ControlPoint& point : points_) {
      regions_.emplace_back(point.rest);
    }
    for (const Membership& members : reachedByEach(progress)) {
      mark(members);
    }
    std::vector<bool> hasFace(static_cast<std::size_t>(mesh_.vertexCount()), false);
    for (const Index vertex : mesh_.mesh().faces.vertices()) {
      hasFace[vertex] = true;
    }
    const std::vector<Index>& order = mesh_.mortonOrder();
    for (std::size_t slot = 0; slot < order.size(); ++slot) {
      if (!isReached(slot) && hasFace[order[slot]]) {
        progress.throwIfCancelled();
        takeIn(static_cast<Index>(slot));
        result_.uncovered += !isReached(slot);
      }
    }
  }

  const Coverage& result() const { return result_; }

 private:
  /// The vertices that a point counts.
  Membership reachedBy(const ControlPoint& point) { return pbffd::reachedBy(point, blocks_, walks_); }

  std::vector<Membership> reachedByEach(const Progress& progress) {
    std::vector<Membership> reached(points_.size());
    parallelFor(points_.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.isCancelled(); ++i) {
        reached[i] = reachedBy(points_[i]);
      }
    });
    progress.throwIfCancelled();
    return reached;
  }

  bool isReached(std::size_t slot) const {
    return (isReached_[slot / PointBlocks::blockSize] >> slot % PointBlocks::blockSize & 1) != 0;
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

  void mark(const Membership& members) {
    for (std::size_t e = 0; e < members.blocks.size(); ++e) {
      isReached_[members.blocks[e]] |= members.members[e];
    }
  }

  void takeIn(Index slot) {
    const Vec3 vertex = mesh_.positions().row(mesh_.mortonOrder()[slot]);
    // By what they were at first: one that has grown would else be the nearest to more and more.
    std::vector<std::pair<double, std::size_t>> byDistance;
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      byDistance.emplace_back(regions_[i].squaredDistance(vertex), i);
    }
    const std::size_t tried = std::min(regionsTried, byDistance.size());
    std::partial_sort(byDistance.begin(), byDistance.begin() + static_cast<std::ptrdiff_t>(tried),
                      byDistance.end());
    for (std::size_t t = 0; t < tried; ++t) {
      if (growIfItReaches(byDistance[t].second, factorToTakeIn(byDistance[t].second, vertex), slot)) {
        return;
      }
    }
    // A region that holds the whole mesh reaches all of it.
    const std::size_t nearest = byDistance[0].second;
    for (double factor = factorToTakeIn(nearest, vertex); factor < 1e6; factor *= growthOfLastResort) {
      if (growIfItReaches(nearest, factor, slot)) {
        return;
      }
    }
  }

  double factorToTakeIn(std::size_t point, const Vec3& vertex) const {
    const Region region(points_[point].rest);
    return std::max(1.0, std::sqrt(region.squaredDistance(vertex)) / takenInAt);
  }

  bool growIfItReaches(std::size_t point, double factor, Index slot) {
    ControlPoint larger = points_[point];
    larger.rest = scaled(larger.rest, factor);
    larger.pose = larger.rest;
    const Membership reached = reachedBy(larger);
    const auto at =
        std::lower_bound(reached.blocks.begin(), reached.blocks.end(), slot / PointBlocks::blockSize);
    if (at == reached.blocks.end() || *at != slot / PointBlocks::blockSize ||
        (reached.members[at - reached.blocks.begin()] >> slot % PointBlocks::blockSize & 1) == 0) {
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
  std::vector<std::uint16_t> isReached_;  ///< one a block: bit k for its k-th vertex
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
