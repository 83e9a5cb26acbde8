#include "core/ffd/refinement/refined_places.h"

#include "core/base/parallel.h"
#include "core/ffd/basis.h"
#include "core/ffd/placement/interior_samples.h"
#include "core/ffd/weights/point_blocks.h"
#include "core/mesh/face_vertices.h"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace pbffd {
namespace {

/// An exterior point stands so far from the surface, as a share of its region's size.
constexpr double offsetShare = 0.5;
/// New points stand so far apart, as a share of the region's size over the root of the factor.
constexpr double leastSpacing = 0.15;
/// Where the nearest vertex lies at most, between centre and border of the largest region allowed.
constexpr double touchedAt = 0.8;
/// More places inside than these are not asked for.
constexpr std::ptrdiff_t mostInside = 20000;

bool belongsTo(Side side, PointKind kind) {
  return kind == PointKind::interior   ? side == Side::inside
         : kind == PointKind::exterior ? side == Side::outside
                                       : true;
}

double medianSize(const RefinementTask& task) {
  std::vector<double> sizes;
  for (const Index place : task.places) {
    sizes.push_back(sizeOf(task.level[place].rest));
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

void appendAll(PointPool& pool, const PointPool& more) {
  for (Index i = 0; i < more.size(); ++i) {
    pool.append(more.points.row(i), more.parts[static_cast<std::size_t>(i)]);
  }
  pool.shrink();
}

struct Candidate {
  Vec3 position;
  Index refines;       ///< -1: nothing
  double distance;     ///< of the nearest point so far; 0 where it cannot be taken
  double least = 1.0;  ///< the distance that it needs

  double room() const { return distance / least; }
};

/// Finds what of a pool may be taken, and for which point.
class Candidates {
 public:
  Candidates(const RefinementTask& task, const SurfaceParts& parts, const RestMesh& mesh)
      : task_(task),
        parts_(parts),
        order_(mesh.mortonOrder()),
        vertices_(mesh.positions(), order_),
        hasFace_(hasFaceFlags(mesh.mesh())),
        isRefined_(static_cast<std::size_t>(task.level.size()), false) {
    for (const Index place : task.places) {
      isRefined_[static_cast<std::size_t>(place)] = true;
    }
  }

  /// The places of a pool that lie in a refined region and are nearest to its point.
  void collect(const PointPool& pool, Side side, std::vector<Candidate>& found,
               const Progress& progress) const {
    std::vector<Candidate> all(static_cast<std::size_t>(pool.size()));
    parallelFor(all.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.isCancelled(); ++i) {
        all[i] = candidate(pool.points.row(static_cast<Index>(i)), side);
      }
    });
    progress.throwIfCancelled();
    std::copy_if(all.begin(), all.end(), std::back_inserter(found),
                 [](const Candidate& one) { return one.refines >= 0; });
  }

  /// Whether a region there would reach a vertex, and no wall stands before the point that it refines. Takes
  /// longer, so only those are asked that would be taken.
  bool isUsable(const Candidate& one) const {
    const Frame& rest = task_.level[one.refines].rest;
    const Region touched({one.position, touchedAt * greatestShare(task_.factor) * rest.axes});
    const std::vector<Index> blocks = vertices_.blocksNear(touched);
    return std::any_of(blocks.begin(), blocks.end(), [&](Index block) { return touches(block, touched); }) &&
           !parts_.isBetween(rest.center, one.position);
  }

 private:
  /// Whether a vertex of the block that has a face is in the region.
  bool touches(Index block, const Region& region) const {
    for (unsigned left = vertices_.inside(block, region); left != 0; left &= left - 1) {
      const Index slot = block * PointBlocks::blockSize + std::countr_zero(left);
      if (hasFace_[static_cast<std::size_t>(order_[static_cast<std::size_t>(slot)])]) {
        return true;
      }
    }
    return false;
  }

  Candidate candidate(const Vec3& position, Side side) const {
    Candidate result{position, -1, std::numeric_limits<double>::infinity()};
    Index nearest = -1;
    for (Index i = 0; i < task_.level.size(); ++i) {
      const ControlPoint& point = task_.level[i];
      if (const double distance = (point.rest.center - position).norm();
          point.enabled && belongsTo(side, point.kind) && distance < result.distance) {
        result.distance = distance;
        nearest = i;
      }
    }
    if (nearest >= 0 && isRefined_[static_cast<std::size_t>(nearest)] &&
        Region(task_.level[nearest].rest).squaredDistance(position) < 1.0) {
      result.refines = nearest;
      result.least = leastSpacing * sizeOf(task_.level[nearest].rest) / std::sqrt(task_.factor);
    }
    return result;
  }

  const RefinementTask& task_;
  const SurfaceParts& parts_;
  const std::vector<Index>& order_;
  PointBlocks vertices_;
  std::vector<bool> hasFace_;
  std::vector<bool> isRefined_;
};

/// Takes candidates one by one, each time the one that is farthest from all points so far, by the distance that
/// the region which it refines calls for.
class Choice {
 public:
  Choice(const Candidates& finder, std::vector<Candidate> candidates, const Progress& progress)
      : finder_(finder), candidates_(std::move(candidates)), progress_(progress) {}

  /// One for the point at this place of the level, or for any; false where all stand too near to others. The
  /// first on a tie.
  bool take(std::optional<Index> refines) {
    for (Candidate* best = farthest(refines); best != nullptr; best = farthest(refines)) {
      progress_.throwIfCancelled();
      if (finder_.isUsable(*best)) {
        takeThis(*best);
        return true;
      }
      best->distance = 0.0;
    }
    return false;
  }

  const std::vector<RefinedPlace>& chosen() const { return chosen_; }

 private:
  Candidate* farthest(std::optional<Index> refines) {
    Candidate* best = nullptr;
    for (Candidate& one : candidates_) {
      if ((!refines || one.refines == *refines) && one.room() >= 1.0 &&
          (best == nullptr || one.room() > best->room())) {
        best = &one;
      }
    }
    return best;
  }

  void takeThis(const Candidate& taken) {
    const Vec3 center = taken.position;
    chosen_.push_back({center, taken.refines});
    for (Candidate& one : candidates_) {
      one.distance = std::min(one.distance, (one.position - center).norm());
    }
  }

  const Candidates& finder_;
  std::vector<Candidate> candidates_;
  const Progress& progress_;
  std::vector<RefinedPlace> chosen_;
};

}  // namespace

double sizeOf(const Frame& region) {
  return std::cbrt(std::abs(region.axes.determinant()));
}

double greatestShare(int factor) {
  return 1.0 / std::cbrt(static_cast<double>(factor));
}

RefinementPools refinementPools(const std::shared_ptr<const RestMesh>& mesh, const RefinementTask& task,
                                const PlacementOptions& options, std::shared_ptr<const PlacementCache>& cache,
                                const Progress& progress) {
  cache = PlacementCache::make(mesh, options, progress, cache.get());
  PlacementOptions nearer = options;
  nearer.offset = std::min(
      options.offset, offsetShare * medianSize(task) / (std::sqrt(task.factor) * cache->parts->diagonal()));
  const auto used = PlacementCache::make(mesh, nearer, progress, cache.get());
  RefinementPools pools;
  pools.parts = used->parts;
  pools.inside = *used->interior;
  appendAll(pools.inside, used->exterior->enclosed);
  pools.outside = used->exterior->outside;
  appendAll(pools.outside, used->exterior->around);
  return pools;
}

void spreadInside(RefinementPools& pools, const RefinementTask& task, int placesForEach, unsigned seed,
                  const Progress& progress) {
  const auto mayBeInside = [](const ControlPoint& point) { return point.kind != PointKind::exterior; };
  if (std::none_of(task.places.begin(), task.places.end(),
                   [&](Index place) { return mayBeInside(task.level[place]); })) {
    return;
  }
  const auto inside = std::count_if(task.level.begin(), task.level.end(), mayBeInside);
  const auto wanted = std::min(placesForEach * task.factor * inside, mostInside);
  pools.inside = withInteriorSamples(pools.inside, static_cast<Index>(wanted), *pools.parts, seed, progress);
}

std::vector<RefinedPlace> refinedPlaces(const RefinementTask& task, const RefinementPools& pools,
                                        const RestMesh& mesh, const Progress& progress) {
  std::vector<Candidate> candidates;
  const Candidates finder(task, *pools.parts, mesh);
  finder.collect(pools.inside, Side::inside, candidates, progress);
  finder.collect(pools.outside, Side::outside, candidates, progress);
  Choice choice(finder, std::move(candidates), progress);
  const std::size_t wanted = task.places.size() * static_cast<std::size_t>(task.factor - 1);
  for (int round = 1; round < task.factor; ++round) {
    for (const Index place : task.places) {
      choice.take(place);
    }
  }
  // What one has no room for goes to the others.
  while (choice.chosen().size() < wanted && choice.take(std::nullopt)) {
  }
  return choice.chosen();
}

}  // namespace pbffd
