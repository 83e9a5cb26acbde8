#pragma once

#include "core/ffd/placement/decimation.h"

namespace pbffd {

/// mergeClosestPairs() without rules for up to a few hundred points: every distance is looked at again where a
/// partner is lost, in plain arrays, which is faster than a tree for so few.
MergedPoints mergeFewClosestPairs(const Points& points, Index target);

}  // namespace pbffd
