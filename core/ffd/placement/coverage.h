#pragma once

#include "core/base/progress.h"
#include "core/ffd/control_point.h"
#include "core/mesh/rest_mesh.h"

#include <vector>

namespace pbffd {

/// Makes regions larger until each reaches a vertex that has a face and each such vertex is reached by one
/// (McDonnell & Qin, 3.2.2: no vertex under the master alone). A vertex is taken in by the region that it
/// is nearest to, measured by the regions' first sizes; it is grown until the vertex lies at 0.8 of its way to
/// the border. `reach` counts: a region may have to grow until the vertex is joined to it along the surface,
/// which it is at the latest when the region holds the whole mesh. How many times regions were made larger.
/// Throws Cancelled.
Index growCoverage(std::vector<ControlPoint>& points, const RestMesh& mesh, const Progress& progress);

}  // namespace pbffd
