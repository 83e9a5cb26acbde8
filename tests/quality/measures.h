#pragma once

#include "core/mesh/mesh.h"

namespace pbffd::test {

/// How well a deformed surface kept its shape: the measures by which methods of surface deformation are
/// compared (Botsch and Sorkine, "On linear variational surface deformation methods", 2008).
struct Quality {
  double volumeChange = 0.0;  ///< percent of the rest volume, signed
  double stretch95 = 0.0;     ///< max(s1, 1/s2) of the triangles, 95th percentile
  double stretchMax = 0.0;    ///< the same, largest
  double jump99 =
      0.0;        ///< change of the angle between normals of neighbouring triangles, 99th percentile, degrees
  int folds = 0;  ///< edges at which the surface turned over (angle changed by more than 120 degrees)
};

/// What the surface encloses; negative where it faces inwards.
double volume(const Points& points, const Triangles& triangles);

/// Both N x 3, over the same triangles.
Quality measure(const Points& rest, const Points& deformed, const Triangles& triangles);

/// Root mean square distance and largest distance between two shapes, percent of the rest diagonal.
struct Deviation {
  double rms = 0.0;
  double largest = 0.0;
};
Deviation deviation(const Points& shape, const Points& wanted, double diagonal);

}  // namespace pbffd::test
