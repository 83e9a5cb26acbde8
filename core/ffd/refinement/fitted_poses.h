#pragma once

#include "core/base/progress.h"
#include "core/ffd/control_set.h"
#include "core/mesh/rest_mesh.h"

#include <memory>
#include <vector>

namespace pbffd {

/// New control points that take part in a deformation which is there already.
struct FittedPoints {
  std::vector<ControlPoint> points;
  double change = 0.0;  ///< how far the vertex moves that they move most, in mesh units
};

/// Gives each point the pose whose full 3 x 4 map follows the deformation of the finest level of `set` most
/// nearly in the point's region: least squares over the vertices that it reaches, weighted by its basis values,
/// and a little over places around, which fill in what the vertices leave open. An affine deformation is met
/// exactly. Regions in which a map cannot follow so well that all vertices stay within `allowed` mesh units of
/// where they are become smaller. The same bits on any number of threads. Throws Cancelled.
FittedPoints fittedPoints(std::vector<ControlPoint> points, const std::shared_ptr<const RestMesh>& mesh,
                          const ControlSet& set, double allowed, const Progress& progress);

}  // namespace pbffd
