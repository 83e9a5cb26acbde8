#pragma once

#include "core/ffd/control_set.h"

#include <vector>

namespace pbffd {

/// The turn that each moved point's frame makes with its neighbours, by a weighted Procrustes fit: the
/// rotation that best carries the offsets to those of its 10 nearest control points (by rest centres) that
/// moved too onto what they became. Where these lie on a line the least rotation is taken. Fewer than three
/// of them, or neighbours that all moved by the very same vector: no turn.
///
/// places: the moved points of `level`, each once; displacements: beside `places`, what was added to each
/// posed centre; `level` is the one before the edit. One rotation a place.
std::vector<Mat3> followingRotations(const Level& level, const std::vector<Index>& places,
                                     const std::vector<Vec3>& displacements);

}  // namespace pbffd
