#include "core/ffd/placement/coverage.h"

#include "core/base/lazy.h"
#include "core/base/parallel.h"
#include "core/ffd/weights/reach.h"
#include "core/mesh/face_vertices.h"
#include "core/mesh/nearest.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
        hasFace_(static_cast<std::size_t>(blocks_.blockCount()), 0),
        isReached_(hasFace_) {
    const std::vector<bool> hasFace = hasFaceFlags(mesh.mesh());
    for (std::size_t slot = 0; slot < hasFace.size(); ++slot) {
      const bool isSet = hasFace[mesh.mortonOrder()[slot]];
      hasFace_[slot / PointBlocks::blockSize] |= static_cast<unsigned>(isSet) << slot % PointBlocks::blockSize;
    }
  }

  void coverAll(const Progress& progress) {
    growToTouch(progress);
    for (const ControlPoint& point : points_) {
      regions_.emplace_back(point.rest);
    }
    for (const Membership& members : reachedByEach(progress)) {
      mark(members);
    }
    for (Index slot = 0; slot < mesh_.vertexCount(); ++slot) {
      if (!isSet(isReached_, slot) && isSet(hasFace_, slot)) {
        progress.throwIfCancelled();
        takeIn(slot);
      }
    }
  }

  Index grown() const { return grown_; }

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

  /// One a block: bit k for its k-th vertex.
  using SlotBits = std::vector<std::uint16_t>;

  static bool isSet(const SlotBits& bits, Index slot) {
    return (bits[slot / PointBlocks::blockSize] >> slot % PointBlocks::blockSize & 1) != 0;
  }

  bool touches(const Region& region) const {
    const Membership inside = pointsInside(blocks_, region);
    for (std::size_t e = 0; e < inside.blocks.size(); ++e) {
      if ((inside.members[e] & hasFace_[inside.blocks[e]]) != 0) {
        return true;
      }
    }
    return false;
  }

  /// The nearest vertex that has a face.
  Vec3 nearestOnSurface(const Vec3& center) {
    const auto& [surface, tree] = surface_.get([&] {
      FacePositions positions(mesh_.mesh());
      NearestPoints nearest = NearestPoints::over(positions.points());
      return std::pair(std::move(positions), std::move(nearest));
    });
    return surface.points().row(tree.nearest(center).index);
  }

  void growToTouch(const Progress& progress) {
    std::vector<std::uint8_t> hasGrown(points_.size(), 0);
    parallelFor(points_.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.isCancelled(); ++i) {
        const Region region(points_[i].rest);
        if (!touches(region)) {
          grow(i, std::sqrt(region.squaredDistance(nearestOnSurface(points_[i].rest.center))) / takenInAt);
          hasGrown[i] = 1;
        }
      }
    });
    progress.throwIfCancelled();
    grown_ += static_cast<Index>(std::count(hasGrown.begin(), hasGrown.end(), 1));
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
    // A region that holds the whole mesh reaches all of it, so this comes to an end.
    const std::size_t nearest = byDistance[0].second;
    double factor = factorToTakeIn(nearest, vertex);
    while (!growIfItReaches(nearest, factor, slot)) {
      factor *= growthOfLastResort;
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
    ++grown_;
    return true;
  }

  std::vector<ControlPoint>& points_;
  const RestMesh& mesh_;
  std::vector<Region> regions_;  ///< before any vertex was taken in
  PointBlocks blocks_;
  ReachWalks walks_;
  SlotBits hasFace_;
  SlotBits isReached_;
  Lazy<std::pair<FacePositions, NearestPoints>> surface_;
  Index grown_ = 0;
};

}  // namespace

Index growCoverage(std::vector<ControlPoint>& points, const RestMesh& mesh, const Progress& progress) {
  if (points.empty() || mesh.mesh().faces.empty()) {
    return 0;
  }
  Cover cover(points, mesh);
  cover.coverAll(progress);
  return cover.grown();
}

}  // namespace pbffd
