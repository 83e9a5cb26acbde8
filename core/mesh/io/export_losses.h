#pragma once

#include "core/mesh/mesh.h"

#include <string>
#include <vector>

namespace pbffd {

/// What an export of `mesh` to `format` leaves out or changes, a sentence each for the user; none in the
/// format that the mesh was read from. format: not `none`.
std::vector<std::string> exportLosses(const Mesh& mesh, MeshFormat format);

}  // namespace pbffd
