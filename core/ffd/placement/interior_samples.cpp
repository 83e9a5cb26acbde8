#include "core/ffd/placement/interior_samples.h"

#include "core/ffd/placement/random_order.h"
#include "core/ffd/placement/spaced_picks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace pbffd {
namespace {

/// A grid over the bounds with cells of one size, or smaller along an axis that has room for few.
struct Grid {
  std::size_t counts[3];
  Vec3 first;  ///< the middle of the first cell
  Vec3 cell;

  Grid(const Bounds& bounds, double size) : first(bounds.low), cell(Vec3::Constant(size)) {
    constexpr double few = 4.0;
    const Vec3 extent = bounds.high - bounds.low;
    for (int axis = 0; axis < 3; ++axis) {
      double count = std::min(std::ceil(extent[axis] / size), 1e9);
      if (extent[axis] < few * size) {
        // Else none might lie within a thin plate.
        count = std::max(1.0, count);
        cell[axis] = extent[axis] / count;
        first[axis] += 0.5 * cell[axis];
      } else {
        count += 1.0;
      }
      counts[axis] = static_cast<std::size_t>(count);
    }
  }
  double total() const {
    return static_cast<double>(counts[0]) * static_cast<double>(counts[1]) * static_cast<double>(counts[2]);
  }
};

/// Of each closed part.
std::vector<Bounds> boundsOfClosedParts(const SurfaceParts& parts) {
  std::vector<Bounds> bounds(static_cast<std::size_t>(parts.count()));
  std::vector<bool> isKnown(bounds.size(), false);
  for (Index v = 0; v < parts.mesh().vertexCount(); ++v) {
    const Index part = parts.partOfVertex()[v];
    if (part < 0 || !parts.isClosed(part)) {
      continue;
    }
    const Vec3 at = parts.mesh().positions().row(v);
    Bounds& own = bounds[static_cast<std::size_t>(part)];
    own = isKnown[part] ? Bounds{own.low.cwiseMin(at), own.high.cwiseMax(at)} : Bounds{at, at};
    isKnown[part] = true;
  }
  std::vector<Bounds> known;
  for (std::size_t part = 0; part < bounds.size(); ++part) {
    if (isKnown[part]) {
      known.push_back(bounds[part]);
    }
  }
  return known;
}

/// A point of each cell of a grid over the bounds, somewhere in its middle.
void scatter(const Bounds& bounds, double size, double greatestGrid, unsigned seed, PointPool& scattered) {
  Grid grid(bounds, size);
  while (grid.total() > greatestGrid) {
    size *= 1.25;
    grid = Grid(bounds, size);
  }
  const auto total = static_cast<std::size_t>(grid.total());
  for (std::size_t i = 0; i < total; ++i) {
    const std::size_t at[3] = {i % grid.counts[0], i / grid.counts[0] % grid.counts[1],
                               i / grid.counts[0] / grid.counts[1]};
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
      const double shift = 0.5 * (randomShare(seed, 3 * i + axis) - 0.5);
      point[axis] = grid.first[axis] + grid.cell[axis] * (static_cast<double>(at[axis]) + shift);
    }
    scattered.append(point, 0);
  }
}

/// Points spread over the inside, about one in each cube of this size. Each closed part has a grid of its own,
/// for small ones may lie far apart.
std::vector<Vec3> scatteredInside(const SurfaceParts& parts, double size, unsigned seed,
                                  const Progress& progress) {
  // However small the volume is in its box, no more than fit in memory.
  constexpr double greatestTotal = 1e6;
  const std::vector<Bounds> bounds = boundsOfClosedParts(parts);
  const double greatestGrid = std::max(64.0, greatestTotal / static_cast<double>(bounds.size()));
  PointPool scattered;
  for (const Bounds& one : bounds) {
    scatter(one, size, greatestGrid, seed, scattered);
  }
  scattered.shrink();
  const std::vector<bool> isInside = parts.likelyInsideFlags(scattered.points, progress);
  std::vector<Vec3> inside;
  for (Index i = 0; i < scattered.size(); ++i) {
    if (isInside[i]) {
      inside.emplace_back(scattered.points.row(i));
    }
  }
  return inside;
}

/// The part of the nearest vertex that belongs to a closed part.
Index partNear(const SurfaceParts& parts, const Vec3& point) {
  for (int k = 8; k <= 512; k *= 8) {
    for (const auto& neighbour : parts.mesh().nearestVertex().nearest(point, k)) {
      const Index part = parts.partOfVertex()[neighbour.index];
      if (part >= 0 && parts.isClosed(part)) {
        return part;
      }
    }
  }
  for (Index part = 0; part < parts.count(); ++part) {
    if (parts.isClosed(part)) {
      return part;
    }
  }
  return 0;
}

PointPool thoseOf(const PointPool& pool, const std::vector<bool>& isKept) {
  PointPool kept;
  for (Index i = 0; i < pool.size(); ++i) {
    if (isKept[i]) {
      kept.append(pool.points.row(i), pool.parts[i]);
    }
  }
  kept.shrink();
  return kept;
}

/// A few candidates for each that is wanted, the best spaced first.
constexpr double candidatesPerPoint = 4.0;

/// How many points are wanted, and how they shall stand.
struct Wanted {
  Index count;
  double spacing;
  unsigned seed;
};

/// The usual distance of so many points that share a volume; a little less than dart throwing gives.
double spacingIn(double volume, Index count) {
  constexpr double packing = 0.7;
  return packing * std::cbrt(volume / count);
}

/// Those of a pool that stand as far apart as is wanted, whatever their part; no more than are wanted.
SpacedPicks wellSpaced(const PointPool& pool, const Wanted& wanted, const Bounds& bounds) {
  SpacedPicks picks(bounds.low, bounds.high, wanted.spacing);
  const RandomOrder order(static_cast<std::uint64_t>(pool.size()), wanted.seed);
  for (Index i = 0; i < pool.size() && picks.size() < wanted.count; ++i) {
    picks.pick({pool.points.row(static_cast<Index>(order[i])), Vec3::Zero(), 0, wanted.spacing});
  }
  return picks;
}

/// The pool without places that are no choice of their own, since another of their part is too near: the
/// thousands of Voronoi vertices in a sphere's centre are one place. Else octree cells, each of which gives up
/// its share, would take what there is elsewhere to leave many there.
PointPool distinctPlaces(const PointPool& pool, const Wanted& wanted, const Bounds& bounds) {
  // Along an axis there are still about four times as many as find room, on a medial surface 16 times.
  constexpr double leastShareOfSpacing = 0.25;
  const double least = leastShareOfSpacing * wanted.spacing;
  SpacedPicks picks(bounds.low, bounds.high, least);
  const RandomOrder order(static_cast<std::uint64_t>(pool.size()), wanted.seed);
  std::vector<bool> isKept(static_cast<std::size_t>(pool.size()), false);
  for (Index i = 0; i < pool.size(); ++i) {
    const auto place = static_cast<Index>(order[i]);
    isKept[place] = picks.pick({pool.points.row(place), Vec3::Zero(), pool.parts[place], least});
  }
  return thoseOf(pool, isKept);
}

/// Points spread over the inside that keep off those of a pool which stand well apart; so many that with these
/// there are as many as are wanted, closer together where they find no room. Each is inside by the winding
/// number.
PointPool samplesBeside(const PointPool& pool, const Wanted& wanted, const SurfaceParts& parts,
                        const Progress& progress) {
  constexpr int attempts = 9;
  constexpr double closer = 0.7;
  SpacedPicks picks = wellSpaced(pool, wanted, parts.bounds());
  const Index missing = wanted.count - picks.size();
  const double cell = std::cbrt(parts.volume() / (candidatesPerPoint * wanted.count));
  const std::vector<Vec3> candidates = scatteredInside(parts, cell, wanted.seed, progress);
  const RandomOrder order(candidates.size(), wanted.seed + 1);
  std::vector<bool> isDone(candidates.size(), false);
  PointPool samples;
  double spacing = wanted.spacing;
  for (int attempt = 1; attempt <= attempts && samples.size() < missing; ++attempt) {
    for (std::size_t i = 0; i < candidates.size() && samples.size() < missing; ++i) {
      const Vec3& candidate = candidates[order[i]];
      if (!isDone[order[i]] && picks.pick({candidate, Vec3::Zero(), 0, spacing})) {
        isDone[order[i]] = true;
        if (parts.isInside(candidate)) {
          samples.append(candidate, partNear(parts, candidate));
        }
      }
    }
    spacing = attempt + 1 < attempts ? closer * spacing : 0.0;
  }
  return samples;
}

/// A ball inside that holds fewer places than its share of the volume.
struct HollowBall {
  Vec3 center;
  double radius;
};

/// Between coarse vertices the surface may run through a ball that no vertex is in.
bool isWhollyInside(const HollowBall& ball, const SurfaceParts& parts) {
  constexpr double nearlyAtBorder = 0.9;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      if (!parts.isInside(ball.center + side * nearlyAtBorder * ball.radius * Vec3::Unit(axis))) {
        return false;
      }
    }
  }
  return true;
}

/// The balls about well-spaced places, as large as the surface lets them be, in which the medial surface has
/// shrunk to a point or a line, for it holds few of these places.
std::vector<HollowBall> hollowBalls(const std::vector<Vec3>& places, const Wanted& wanted,
                                    const SurfaceParts& parts) {
  constexpr double leastExpected = 8.0;
  constexpr double fewShare = 0.25;
  // Of very many places a part is looked at; they come in random order, and large balls hold many.
  constexpr std::size_t mostComparisons = 10'000'000;
  std::size_t left = mostComparisons / std::max<std::size_t>(1, places.size());
  std::vector<HollowBall> hollow;
  for (const Vec3& place : places) {
    const double radius = parts.mesh().nearestVertex().nearest(place).distance;
    const double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    const double expected = wanted.count * std::min(1.0, volume / parts.volume());
    const bool isKnown = std::any_of(hollow.begin(), hollow.end(), [&](const HollowBall& ball) {
      return (place - ball.center).norm() + radius < 1.1 * ball.radius;
    });
    if (expected < leastExpected || isKnown) {
      continue;
    }
    if (left-- == 0) {
      break;
    }
    const auto held = std::count_if(places.begin(), places.end(), [&](const Vec3& other) {
      return (other - place).squaredNorm() < radius * radius;
    });
    if (static_cast<double>(held) < fewShare * expected && isWhollyInside({place, radius}, parts)) {
      hollow.push_back({place, radius});
    }
  }
  return hollow;
}

/// The pool, and well-spaced points in its hollow balls. Each of these is inside by the winding number.
PointPool withHollowBallsFilled(PointPool pool, const Wanted& wanted, const SurfaceParts& parts,
                                const Progress& progress) {
  SpacedPicks picks = wellSpaced(pool, {pool.size(), wanted.spacing, wanted.seed}, parts.bounds());
  const std::vector<HollowBall> balls = hollowBalls(picks.positions(), wanted, parts);
  if (balls.empty()) {
    return pool;
  }
  const double cell = std::cbrt(parts.volume() / (candidatesPerPoint * wanted.count));
  for (const Vec3& candidate : scatteredInside(parts, cell, wanted.seed, progress)) {
    const bool isInBall = std::any_of(balls.begin(), balls.end(), [&](const HollowBall& ball) {
      return (candidate - ball.center).squaredNorm() < ball.radius * ball.radius;
    });
    if (isInBall && picks.pick({candidate, Vec3::Zero(), 0, wanted.spacing}) && parts.isInside(candidate)) {
      pool.append(candidate, partNear(parts, candidate));
    }
  }
  pool.shrink();
  return pool;
}

}  // namespace

PointPool withInteriorSamples(const PointPool& pool, Index target, const SurfaceParts& parts, unsigned seed,
                              const Progress& progress) {
  if (target <= 0 || !(parts.volume() > 0.0)) {
    return pool;
  }
  const Wanted wanted{target, spacingIn(parts.volume(), target), seed};
  const auto likelyInside = [&](const PointPool& of) {
    return thoseOf(of, parts.likelyInsideFlags(of.points, progress));
  };
  const auto distinct = [&](const PointPool& of) { return distinctPlaces(of, wanted, parts.bounds()); };
  if (PointPool places = likelyInside(distinct(pool));
      wellSpaced(places, wanted, parts.bounds()).size() >= target) {
    return withHollowBallsFilled(std::move(places), wanted, parts, progress);
  }
  // On plates and needles votes go wrong; here, where few points are, no vote counts.
  const PointPool inside = likelyInside(pool);
  PointPool filled = distinct(inside);
  filled = thoseOf(filled, parts.insideFlags(filled.points, progress));
  const auto append = [&](const PointPool& more) {
    for (Index i = 0; i < more.size(); ++i) {
      filled.append(more.points.row(i), more.parts[i]);
    }
  };
  append(samplesBeside(filled, wanted, parts, progress));
  if (filled.size() < target) {
    // Of a volume that is nearly nothing in its box no grid finds enough.
    append(inside);
    filled.dropDoubles();
  }
  filled.shrink();
  return withHollowBallsFilled(std::move(filled), wanted, parts, progress);
}

}  // namespace pbffd
