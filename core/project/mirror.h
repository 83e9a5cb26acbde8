#pragma once

#include "core/project/edit.h"

#include <vector>

namespace pbffd {

/// The reflection across the plane at right angles to `axis` that passes through `through`.
AffineMap reflection(Axis axis, const Vec3& through);

/// The mirror partner of each control point of a level: its place, the point's own place where it lies on the
/// plane, or -1 for none. Partners are mutual nearest mirrored rest centres, each within a tenth of the
/// other's region of where the mirror image falls.
std::vector<Index> mirrorPartners(const Level& level, Axis axis, const Vec3& through);

/// The point that the mirror planes of an edit pass through: its own, or the middle of the mesh's bounds.
Vec3 mirrorCenter(const Project& project, const Spread& spread);

}  // namespace pbffd
