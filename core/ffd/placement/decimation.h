#pragma once

#include "core/base/progress.h"
#include "core/base/types.h"

#include <functional>
#include <vector>

namespace pbffd {

/// Two points that became one: the mid-point took the place of the lower of the two.
struct Merge {
  Index kept;  ///< the lower place, where the mid-point is from then on
  Index gone;  ///< the higher place, which names no point any more
};

/// What is left of a set of points whose closest pairs were merged.
struct MergedPoints {
  Points points;              ///< K x 3, the survivors by ascending place
  std::vector<Index> places;  ///< the place of each survivor among the points given
  std::vector<Merge> merges;  ///< in the order they were made; places are those of the points given
};

/// How merging is steered. With the defaults every pair may merge and the closest goes first.
struct MergeRules {
  /// One a point: points of different groups never merge. Empty: all are of one group.
  std::vector<Index> groups;
  /// By how much a pair is put back: its squared distance counts so many times. At least 1, infinity for a
  /// pair that must not merge, the same for (a, b) and (b, a). May be called from several threads.
  std::function<double(const Vec3& a, const Vec3& b)> factor;
};

/// Merges the closest two points into their mid-point again and again until `target` are left, or until no
/// pair may merge (McDonnell & Qin, 3.2.1 and 3.4). Of equal distances the pair with the lowest place goes
/// first, then the one with the lowest partner: the very result of looking at all pairs each time. Takes
/// O(N log N) time. The same bits on any number of threads. Throws Cancelled.
MergedPoints mergeClosestPairs(const Points& points, Index target, const MergeRules& rules = {},
                               const Progress& progress = {});

/// A smaller set that stands for a larger one.
struct Decimated {
  Points points;
  std::vector<Index> groups;  ///< one a point; empty when none were given
};

/// Decimates in the cells of an octree (McDonnell & Qin, 3.2.1): within each cell the closest pairs are
/// merged, pass after pass, until about `target` points are left. Points of different groups share no
/// cell. Returns the points as they are when there are no more than `target`. Throws Cancelled.
Decimated decimateInOctree(const Points& points, Index target, const MergeRules& rules = {},
                           const Progress& progress = {});

}  // namespace pbffd
