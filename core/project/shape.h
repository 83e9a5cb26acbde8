#pragma once

#include "core/ffd/levels/weight_cache.h"
#include "core/mesh/io/mesh_io.h"
#include "core/project/project.h"

namespace pbffd {

/// Whether nothing moved that the mesh follows: the finest level and the master lie in their rest frames.
bool isAtRest(const ControlSet& set);

/// The vertices of the project's mesh in their present places, N x 3, in double precision.
Points deformedPositions(const Project& project, WeightCache& weights, const Progress& progress = {});

/// The project's mesh in its present pose, in double precision: what is exported. `gradients` stays empty
/// where nothing moved.
DeformedShape deformedShape(const Project& project, WeightCache& weights, const Progress& progress = {});

}  // namespace pbffd
