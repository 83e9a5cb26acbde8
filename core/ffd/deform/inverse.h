#pragma once

#include "core/base/progress.h"
#include "core/ffd/control_set.h"
#include "core/mesh/rest_mesh.h"

#include <memory>
#include <optional>

namespace pbffd {

/// The rest place that the deformation takes to `posed`: damped Newton iteration from where the vertex of
/// the mesh lies whose deformed place is nearest (then from the next nearest ones). `deformed`: the deformed
/// vertices, N x 3. Nothing where no start leads to a place within 1e-12 of the diagonal. Throws Cancelled.
std::optional<Vec3> restPlaceOf(const Vec3& posed, const std::shared_ptr<const RestMesh>& mesh,
                                const ControlSet& set, const Points& deformed, const Progress& progress = {});

}  // namespace pbffd
