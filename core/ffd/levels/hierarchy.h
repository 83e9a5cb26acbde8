#pragma once

#include "core/base/progress.h"
#include "core/ffd/levels/enclosing_region.h"
#include "core/ffd/weights/parameterization.h"

#include <vector>

namespace pbffd {

/// How many levels `finestCount` points allow: each coarser one has half as many (rounded down), the
/// coarsest at least one.
int greatestLevelCount(Index finestCount);

/// The next coarser level (McDonnell & Qin, 3.4): the closest two points, by their rest centres, are merged
/// again and again until half as many (rounded down) are left. A merged point lies at the mid-point of its
/// two, its region encloses theirs; a point that found no partner is taken over as it is. All are of kind
/// `merged`, enabled, not locked and at rest, and name what they stand for in `mergedFrom`. Their identifiers
/// start with nextId, which is advanced. Ties are broken by place: the same input gives the same level.
Level coarserLevel(const Level& finer, PointId& nextId, RegionShape shape = RegionShape::sphere);

/// Builds coarser levels over `finest`, each from the next finer one by coarserLevel(). Returns `levelCount`
/// levels, or fewer where greatestLevelCount() allows no more; coarsest first, `finest` last. The bindings
/// of all but the coarsest are set for rest (at = rest centre, local = identity).
std::vector<Level> buildLevels(const Level& finest, int levelCount, PointId& nextId,
                               RegionShape shape = RegionShape::sphere);

/// The weights by which each level hangs on the next coarser one: entry l binds levels[l + 1] to levels[l].
/// Depends on rest regions, `at`, basis and master only.
std::vector<PointWeights> levelBindings(const RestMesh& mesh, const ControlSet& set,
                                        const Progress& progress = {});

/// Carries an edit of poses down: recomputes the poses of all levels finer than `level` (0 = coarsest) from
/// M = B x local, pose = M x rest (contract, section 4). A point keeps its very bits unless a point or the
/// master that it hangs on has another pose than in `before`, the set that `set` was edited from.
void carryDown(const ControlSet& before, ControlSet& set, Index level,
               const std::vector<PointWeights>& bindings);

/// Sets at := rest centre and local := inverse(B) x M for each point of `level` (0 = coarsest, which has no
/// binding), so that the poses that it has are what the coarser level's present poses give. Throws
/// InvalidInput that names the point where B cannot be inverted.
void rebind(ControlSet& set, Index level, const std::vector<PointWeights>& bindings);

}  // namespace pbffd
