#include "core/project/shape.h"

#include "core/ffd/deform/deformation.h"

#include <algorithm>

namespace pbffd {

bool isAtRest(const ControlSet& set) {
  return set.master.pose == set.master.rest &&
         std::all_of(set.finest().begin(), set.finest().end(),
                     [](const ControlPoint& point) { return point.pose == point.rest; });
}

DeformedShape deformedShape(const Project& project, WeightCache& weights, const Progress& progress) {
  const RestMesh& mesh = *project.mesh;
  if (isAtRest(project.controls)) {
    return {mesh.positions(), {}};
  }
  const auto parameterization = weights.parameterization(project.mesh, project.controls, progress);
  return {deformExactly(mesh, project.controls, *parameterization, progress),
          deformationGradients(mesh, project.controls, *parameterization, progress)};
}

}  // namespace pbffd
