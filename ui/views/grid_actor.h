#pragma once

#include "core/mesh/mesh.h"
#include "ui/views/stroke_actor.h"

namespace pbffd::ui {

/// The lines of the ground grid, fading out with the distance from the middle, and the axes X and Z.
struct Grid {
  double spacing = 1.0;
  std::vector<Stroke> strokes;  ///< in view space
};
struct GridColors {
  Rgba lines{};
  Rgba axisX{};
  Rgba axisZ{};
};
/// Under `bounds` (mesh units); positions are taken relative to `origin`.
Grid makeGrid(const Bounds& bounds, const Vec3& origin, const GridColors& colors);

}  // namespace pbffd::ui
