#pragma once

#include "app/yardsticks/triad.h"
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

/// The same file's mesh in triangles, or else a sphere of 100,000 triangles: what grows by subdivision.
Mesh growingMesh();

/// The file to take instead of the spheres; to be called before theScene().
void useMesh(const std::string& file);

/// Weights with `reach` all.
std::shared_ptr<const Parameterization> sharedWeights(Scene& scene);

/// Every control point moved by a little, one way or the other; turned too where asked for.
LevelMaps movedMaps(const Scene& scene, bool turned, double amount);

/// Of a full pass over the positions after all points moved: the median of some.
double fullPassSeconds(Scene& scene, bool turned);

/// Of this run, measured when first asked for.
const Triad& theTriad();

}  // namespace pbffd::bench
