#pragma once

#include "core/ffd/control_point.h"
#include "ui/views/camera.h"

#include <array>
#include <vector>

namespace pbffd::ui {

/// The three rings of a region: the ellipsoid's sections through the middle, `count` points each.
std::array<std::vector<Vec3>, 3> regionRings(const Frame& frame, int count);

/// The border of the region as the camera sees it: a closed planar curve of `count` points on the ellipsoid.
/// Empty when the eye is inside, or the frame is singular.
std::vector<Vec3> regionOutline(const Frame& frame, const Projection::Lens& lens, int count);

}  // namespace pbffd::ui
