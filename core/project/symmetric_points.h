#pragma once

#include "core/ffd/placement/placement.h"
#include "core/project/edit.h"

#include <functional>

namespace pbffd {

/// Placement that is symmetric across the plane at right angles to `axis` through `through`: of what `placed`
/// gives, the points of the positive side and their mirror images, and those near the plane moved onto it.
/// `placed` is asked for more or fewer points until as many as options.points come out, as nearly as the
/// plane allows; a remark says where one is missing.
PlacementResult symmetricPlacement(const PlacementOptions& options, Axis axis, const Vec3& through,
                                   const std::function<PlacementResult(const PlacementOptions&)>& placed);

}  // namespace pbffd
