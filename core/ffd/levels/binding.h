#pragma once

#include "core/base/progress.h"
#include "core/ffd/weights/parameterization.h"

namespace pbffd {

// How a point hangs on the next coarser level: its map is M = B x local, its pose M x rest (contract,
// section 4).

/// The weights by which `level` (1 or more, 0 is the coarsest) hangs on the next coarser one.
PointWeights bindingWeights(const RestMesh& mesh, const ControlSet& set, Index level,
                            const Progress& progress = {});

/// The pose that the point has under `blend`, the map B of its place.
Frame boundPose(const ControlPoint& point, const AffineMap& blend);

/// The binding at the point's rest centre that leads from `blend`, taken over `level` (0 is the coarsest), to
/// the pose that the point has. Throws InvalidInput that names both where `blend` cannot be inverted, or so
/// badly that the pose would be lost.
Binding bindingTo(const ControlPoint& point, const AffineMap& blend, Index level);

/// Takes anew the bindings that do not give the poses. Edits leave none, a file may hold some. Returns of how
/// many points. Throws like bindingTo().
Index mendBindings(const RestMesh& mesh, ControlSet& set, const Progress& progress = {});

}  // namespace pbffd
