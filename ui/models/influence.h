#pragma once

#include "core/ffd/control_set.h"
#include "core/ffd/weights/parameterization.h"

#include <array>
#include <vector>

namespace pbffd::ui {

/// What a selection of control points reaches: vertices of the mesh on the finest level, control points of
/// the next finer level on any other.
struct Influence {
  static constexpr int binCount = 24;

  Index reached = 0;
  Index total = 0;
  /// How many of what is reached have a joint weight of the selection in each 24th of 0 to 1.
  std::array<Index, binCount> histogram{};
  double strongest = 0.0;  ///< the largest weight of a single point
  PointId strongestPoint = 0;
};

/// Of points of the finest level over the mesh.
Influence influenceOnMesh(const Parameterization& weights, const Level& finest,
                          const std::vector<PointId>& points);

/// Of points of a level over the next finer one, from its binding weights.
Influence influenceOnPoints(const PointWeights& weights, const Level& level,
                            const std::vector<PointId>& points);

}  // namespace pbffd::ui
