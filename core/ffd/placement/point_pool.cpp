#include "core/ffd/placement/point_pool.h"

#include "core/ffd/placement/decimation.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace pbffd {
namespace {

/// A pair across a wall counts as if it were twice as far apart.
constexpr double wallFactor = 4.0;

/// Octree cells, which know no walls, leave so many points for each that is wanted, within these bounds ...
constexpr Index poolFactor = 16;
constexpr Index leastPool = 1000;
constexpr Index greatestPool = 16000;
/// ... but always a choice of so many.
constexpr Index leastFactor = 3;

/// So few places need no octree: their closest pairs merge exactly from the start.
constexpr Index exactPool = 3000;

/// For so few more than are to be left the octree is not worth its while.
constexpr double worthDecimating = 1.25;

Index coarseTarget(Index places, Index target) {
  const Index wanted = std::max(leastFactor * target, std::clamp(poolFactor * target, leastPool, greatestPool));
  return places <= exactPool || places <= worthDecimating * wanted ? places : wanted;
}

/// Which mid-points are asked for their side: those of pairs with a wall between, or each of them.
enum class Asked { acrossWalls, each };

MergeRules rulesFor(const PointPool& pool, Index target, Side side, const SurfaceParts& parts, Asked asked,
                    const Progress& progress) {
  MergeRules rules;
  if (static_cast<Index>(std::set<Index>(pool.parts.begin(), pool.parts.end()).size()) <= target) {
    rules.groups = pool.parts;
  } else {
    rules.groups.assign(pool.parts.size(), 0);
  }
  rules.factor = [side, asked, &parts, &progress](const Vec3& a, const Vec3& b) {
    // Long may pass until two are found that merge.
    progress.throwIfCancelled();
    const auto isOffSide = [&](const Vec3& point) { return parts.isInside(point) != (side == Side::inside); };
    const bool isAcross = parts.isBetween(a, b);
    // Points of a part that lies wholly off side have no side to leave.
    if ((isAcross || asked == Asked::each) && isOffSide(0.5 * (a + b)) && !(isOffSide(a) && isOffSide(b))) {
      return std::numeric_limits<double>::infinity();
    }
    return isAcross ? wallFactor : 1.0;
  };
  return rules;
}

/// Where no pair may merge any more: of each closest pair the one of the higher place goes.
PointPool thinned(const PointPool& pool, Index target) {
  MergedPoints merged = mergeClosestPairs(pool.points, target, {pool.parts, nullptr});
  if (merged.points.rows() > target) {
    merged = mergeClosestPairs(pool.points, target);
  }
  PointPool result;
  for (const Index place : merged.places) {
    result.append(pool.points.row(place), pool.parts[place]);
  }
  result.shrink();
  return result;
}

/// Exact merging, with an eye on walls and sides.
PointPool merged(const PointPool& pool, Index target, const MergeRules& rules, const Progress& progress) {
  const MergedPoints left = mergeClosestPairs(pool.points, target, rules, progress);
  PointPool result{left.points, {}};
  for (const Index place : left.places) {
    result.parts.push_back(pool.parts[place]);
  }
  return result.size() > target ? thinned(result, target) : result;
}

/// isExact: by the winding number of each point.
std::vector<bool> offSide(const PointPool& pool, Side side, const SurfaceParts& parts, bool isExact,
                          const Progress& progress) {
  std::vector<bool> flags =
      isExact ? parts.insideFlags(pool.points, progress) : parts.likelyInsideFlags(pool.points, progress);
  if (side == Side::inside) {
    flags.flip();
  }
  return flags;
}

/// The parts of which no place is on the side; asked are ever more places of those that may yet be.
std::set<Index> partsWhollyOffSide(const PointPool& pool, Side side, const SurfaceParts& parts,
                                   const Progress& progress) {
  std::map<Index, std::vector<Index>> open;
  for (Index i = 0; i < pool.size(); ++i) {
    open[pool.parts[i]].push_back(i);
  }
  std::set<Index> found;
  for (std::size_t begin = 0, end = 1; !open.empty(); begin = end, end *= 2) {
    PointPool asked;
    for (const auto& [part, places] : open) {
      for (std::size_t i = begin; i < std::min(end, places.size()); ++i) {
        asked.append(pool.points.row(places[i]), part);
      }
    }
    asked.shrink();
    const std::vector<bool> isOff = offSide(asked, side, parts, true, progress);
    for (Index i = 0; i < asked.size(); ++i) {
      if (!isOff[i]) {
        open.erase(asked.parts[i]);
      }
    }
    for (auto it = open.begin(); it != open.end();) {
      const bool isDone = it->second.size() <= end;
      if (isDone) {
        found.insert(it->first);
      }
      it = isDone ? open.erase(it) : std::next(it);
    }
  }
  return found;
}

bool hasOffSide(const PointPool& pool, const std::vector<bool>& isOffSide,
                const std::set<Index>& whollyOffSide) {
  for (Index i = 0; i < pool.size(); ++i) {
    if (isOffSide[i] && !whollyOffSide.contains(pool.parts[i])) {
      return true;
    }
  }
  return false;
}

/// Keeps the places of a part that has no others.
PointPool withoutOffSide(const PointPool& pool, const std::vector<bool>& isOffSide,
                         const std::set<Index>& whollyOffSide) {
  std::set<Index> onSide;
  for (Index i = 0; i < pool.size(); ++i) {
    if (!isOffSide[i]) {
      onSide.insert(pool.parts[i]);
    }
  }
  PointPool kept;
  for (Index i = 0; i < pool.size(); ++i) {
    if (!isOffSide[i] || whollyOffSide.contains(pool.parts[i]) || !onSide.contains(pool.parts[i])) {
      kept.append(pool.points.row(i), pool.parts[i]);
    }
  }
  kept.shrink();
  return kept;
}

}  // namespace

void PointPool::append(const Vec3& point, Index part) {
  if (size() == points.rows()) {
    points.conservativeResize(std::max<Eigen::Index>(64, 2 * points.rows()), 3);
  }
  points.row(size()) = point;
  parts.push_back(part);
}

void PointPool::dropDoubles() {
  std::vector<Index> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](Index i) { return std::tuple(points(i, 0), points(i, 1), points(i, 2), i); };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
  std::vector<bool> isDouble(parts.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i) {
    isDouble[order[i]] = points.row(order[i]) == points.row(order[i - 1]);
  }
  Index kept = 0;
  for (Index i = 0; i < size(); ++i) {
    if (!isDouble[i]) {
      points.row(kept) = points.row(i);
      parts[kept++] = parts[i];
    }
  }
  parts.resize(static_cast<std::size_t>(kept));
  shrink();
}

PointPool decimatedPool(const PointPool& pool, Index target, Side side, const SurfaceParts& parts,
                        const Progress& progress) {
  if (target <= 0) {
    return {};
  }
  const auto rules = [&](const PointPool& of, Asked asked) { 
    return rulesFor(of, target, side, parts, asked, progress);
  };
  const PointPool grouped{pool.points, rules(pool, Asked::acrossWalls).groups};
  const std::set<Index> whollyOffSide = partsWhollyOffSide(grouped, side, parts, progress);
  const Decimated coarse = decimateInOctree(grouped.points, coarseTarget(grouped.size(), target),
                                            {grouped.parts, nullptr}, progress);
  PointPool left{coarse.points, coarse.groups};
  if (left.size() < pool.size()) {
    left = withoutOffSide(left, offSide(left, side, parts, false, progress), whollyOffSide);
  }
  PointPool result = merged(left, target, rules(left, Asked::acrossWalls), progress);
  if (hasOffSide(result, offSide(result, side, parts, true, progress), whollyOffSide)) {
    // One was there from the start, or a mid-point came through a hole.
    left = withoutOffSide(left, offSide(left, side, parts, true, progress), whollyOffSide);
    result = merged(left, target, rules(left, Asked::each), progress);
  }
  return result;
}

}  // namespace pbffd
