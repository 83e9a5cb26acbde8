#include "core/project/shape.h"

#include "core/ffd/deform/deformation.h"

#include <algorithm>
#include <utility>

namespace pbffd {

bool isAtRest(const ControlSet& set) {
  return set.master.pose == set.master.rest &&
         std::all_of(set.finest().begin(), set.finest().end(),
                     [](const ControlPoint& point) { return point.pose == point.rest; });
}

Points deformedPositions(const Project& project, WeightCache& weights, const Progress& progress) {
  if (isAtRest(project.controls)) {
    return project.mesh->positions();
  }
  const auto parameterization = weights.parameterization(project.mesh, project.controls, progress);
  return deformExactly(*project.mesh, project.controls, *parameterization, progress);
}

DeformedShape deformedShape(const Project& project, WeightCache& weights, const Progress& progress) {
  Points positions = deformedPositions(project, weights, progress);
  if (isAtRest(project.controls)) {
    return {std::move(positions), {}};
  }
  const auto parameterization = weights.parameterization(project.mesh, project.controls, progress);
  return {std::move(positions),
          deformationGradients(*project.mesh, project.controls, *parameterization, progress)};
}

}  // namespace pbffd
