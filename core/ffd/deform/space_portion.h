#pragma once

#include "core/ffd/deform/displacement.h"
#include "core/ffd/deform/nearest_vertices.h"
#include "core/ffd/deform/region_cuts.h"
#include "core/ffd/deform/space_deformation.h"
#include "core/ffd/weights/level_values.h"

#include <memory>
#include <optional>
#include <vector>

namespace pbffd {

/// Everything that the evaluation of a place needs and that does not depend on it.
struct PreparedSpace {
  std::shared_ptr<const RestMesh> mesh;
  Level level;  ///< with the reaches that the rule gives
  LevelValues values;
  std::vector<RegionCut> cuts;  ///< one a control point
  std::optional<NearestVertices> nearest;  ///< where any of the cuts asks for it
  LevelDisplacements displacements;

  PreparedSpace(std::shared_ptr<const RestMesh> rest, const ControlSet& set, ReachRule rule,
                const Progress& progress);
};

/// The images of a few ten thousand places, on the calling thread. Without gradients these stay empty.
SpaceImage imageOfPortion(const PreparedSpace& space, const Points& places, bool withGradients);

}  // namespace pbffd
