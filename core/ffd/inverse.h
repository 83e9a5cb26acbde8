#pragma once

#include "core/ffd/control_set.h"
#include "core/mesh/rest_mesh.h"

#include <optional>

namespace pbffd {

/// The rest place that the deformation takes to `posed`: damped Newton iteration from where the vertex of
/// the mesh lies whose deformed place is nearest (then from the next nearest ones). `deformed`: the deformed
/// vertices, N x 3. Nothing where no start leads to a place within 1e-12 of the diagonal.
std::optional<Vec3> restPlaceOf(const Vec3& posed, const RestMesh& mesh, const ControlSet& set,
                                const Points& deformed);

}  // namespace pbffd
