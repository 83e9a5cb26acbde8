#pragma once

#include "core/ffd/deform/deformation.h"

#include <memory>
#include <string>

namespace pbffd::bench {

/// A mesh and well-spaced control points near its surface, with regions as large as the default placement's:
/// about 16 influences a vertex.
struct Scene {
  std::shared_ptr<const RestMesh> mesh;
  ControlSet set;
  double influences = 0.0;  ///< a vertex, on average

  Parameterization weights() const { return parameterize(*mesh, set.basis, set.master, set.finest()); }
  void setReach(Reach reach);
};

/// The mesh of the file named on the command line, or else a sphere of a million vertices; 200 points. Made
/// when first asked for.
Scene& theScene();

/// The file to take instead of the sphere; to be called before theScene().
void useMesh(const std::string& file);

/// Bytes a second of STREAM's triad, a = b + s c, on all cores, with arrays far larger than the caches.
double triadBytesPerSecond();

}  // namespace pbffd::bench
