#pragma once

#include "app/dataset/dataset.h"

namespace pbffd {

/// A glTF 2.0 model (.glb, .gltf): the positions, normals and tangents of its meshes are rewritten within its
/// own buffers; skins, morph targets, materials, animations and all else stay. Meshes are deformed where the
/// nodes of the scene place them.
std::unique_ptr<Dataset> openGltfDataset(const std::filesystem::path& path, const Progress& progress);

}  // namespace pbffd
