#pragma once

#include "app/dataset/gltf_document.h"
#include "core/base/affine.h"

#include <map>
#include <set>

namespace pbffd {

/// The positions of a glTF model: an accessor, where the scene places it, and what turns with it.
struct GltfPositions {
  AffineMap toScene = identityMap();
  std::set<std::size_t> normals;   ///< accessors
  std::set<std::size_t> tangents;  ///< accessors
};

struct GltfScene {
  std::map<std::size_t, GltfPositions> positions;  ///< by accessor
  /// Accessors of the very same bytes as one of those above, which alone stands for them.
  std::map<std::size_t, std::set<std::size_t>> twins;
  bool hasMorphTargets = false;
};

/// Throws InvalidInput where one mesh stands in two places of the scene, so that it cannot be bent in both,
/// and where its attributes are stored in a way that cannot be rewritten.
GltfScene sceneOf(const GltfDocument& document);

}  // namespace pbffd
