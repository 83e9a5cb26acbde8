#pragma once

#include "core/base/progress.h"
#include "core/ffd/parameterization.h"

#include <vector>

namespace pbffd {

/// Builds coarser levels under `finest` (McDonnell & Qin, 3.4): each merges the closest pairs of the next
/// finer one until half as many are left; a merged point lies at the mid-point, its sphere encloses both.
/// Returns `levelCount` levels or fewer where a level would have no point, coarsest first, `finest` last.
/// New points are numbered from nextId on, which is advanced; mergedFrom names the two points.
/// Bindings are set for rest (local = identity).
std::vector<Level> buildLevels(const Level& finest, int levelCount, PointId& nextId);

/// The weights by which each level hangs on the next coarser one: entry l binds levels[l + 1] to levels[l].
/// Depends on rest regions, `at`, basis and master only.
std::vector<PointWeights> levelBindings(const RestMesh& mesh, const ControlSet& set,
                                        const Progress& progress = {});

/// Recomputes the poses of all levels finer than `level` from M = B x local (contract, section 4).
void carryDown(ControlSet& set, Index level, const std::vector<PointWeights>& bindings);

/// Sets local := inverse(B) x M for the points at `places` (all when empty) of `level`, after its poses were
/// edited. Throws InvalidInput where B is singular.
void rebind(ControlSet& set, Index level, const std::vector<PointWeights>& bindings);

}  // namespace pbffd
