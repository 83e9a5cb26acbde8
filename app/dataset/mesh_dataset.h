#pragma once

#include "app/dataset/dataset.h"

namespace pbffd {

/// A mesh or a point cloud in a format of core (OBJ, OFF, PLY, STL). In the source's own format positions and
/// normals are rewritten, every other byte stays.
std::unique_ptr<Dataset> openMeshDataset(const std::filesystem::path& path, const Progress& progress);

}  // namespace pbffd
