#pragma once

#include "core/ffd/control_point.h"
#include "core/ffd/placement/placement.h"

namespace pbffd {

/// A region that encloses two others, centred at the mid-point of their centres (McDonnell & Qin, 3.4).
/// sphere: the paper's, radius = half the distance + the larger radius, an ellipsoid counting with its
/// largest semi-axis. ellipsoid: the one of least volume with that centre, to one part in a million, and
/// never less than enclosing. Rest frames in, rest frame out (orthogonal axes).
Frame enclosingRegion(const Frame& first, const Frame& second, RegionShape shape);

}  // namespace pbffd
