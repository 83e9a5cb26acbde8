#include "core/base/figures.h"
#include "core/base/text.h"
#include "core/ffd/levels/hierarchy.h"
#include "core/ffd/placement/placement_cache.h"
#include "core/mesh/face_vertices.h"
#include "core/project/edit_functions.h"
#include "core/project/edit_survivors.h"
#include "core/project/shape.h"
#include "core/project/symmetric_points.h"

#include <algorithm>

namespace pbffd {
namespace {

void requireUsable(const Place& edit) {
  requireValid(edit.options);
  requireLevelCount(edit.options.levels, edit.options.points);
}

PlacementResult place(const EditScope& scope, const Place& edit) {
  const auto placed = [&](const PlacementOptions& options) {
    PlacementResult result =
        scope.workspace.keepsPlacement
            ? placeControlPoints(scope.before.mesh, options, scope.progress, scope.workspace.placement)
            : placeControlPointsOnce(scope.before.mesh, options, scope.progress);
    scope.workspace.placement = result.cache;
    return result;
  };
  if (!edit.symmetric) {
    return placed(edit.options);
  }
  return symmetricPlacement(edit.options, *edit.symmetric, scope.before.mesh->bounds().center(), placed);
}

/// The placed points under identifiers of the project, then the survivors of the finest level.
Level finestLevel(const EditScope& scope, const Level& placed, PointId& nextId) {
  Level level;
  for (ControlPoint point : placed) {
    point.id = nextId++;
    level.append(std::move(point));
  }
  const Level& former = scope.before.controls.finest();
  for (Index i = 0; i < former.size(); ++i) {
    if (survives(former[i])) {
      level.append(former, i);
    }
  }
  return level;
}

int levelCountFor(const EditScope& scope, const Place& edit, Index points) {
  const int greatest = greatestLevelCount(points);
  if (edit.options.levels > greatest) {
    scope.remarks.push_back(format("The {} points placed allow {} of the {} levels.", counted(points), greatest,
                                   edit.options.levels));
  }
  return std::min(edit.options.levels, greatest);
}

/// New points take the blended transforms of their places; survivors have theirs.
void carryAlong(const EditScope& scope, ControlSet& placed) {
  const ControlSet& former = scope.before.controls;
  ControlSet posed = placed;
  poseByDeformation(scope, former, posed, posed.levels.size());
  for (std::size_t l = 0; l < placed.levels.size(); ++l) {
    Level& level = placed.levels[l];
    for (Index i = 0; i < level.size(); ++i) {
      if (level[i].id >= scope.before.nextId) {
        level.replace(i, posed.levels[l][i]);
      }
    }
  }
  placed.master.pose = moved(placed.master.rest, former.master.map());
}

/// How far the surface moved because other points carry it now, in units of the mesh and by its own size:
/// vertices without a face count for nothing.
void remarkDifference(const EditScope& scope, const Project& after) {
  if (isAtRest(scope.before.controls)) {
    return;
  }
  const auto positions = [&](const Project& project) {
    return deformedPositions(project, scope.workspace.weights, scope.progress);
  };
  const RestMesh& mesh = *scope.before.mesh;
  const std::vector<bool> hasFace = hasFaceFlags(mesh.mesh());
  const Eigen::VectorXd moved = (positions(after) - positions(scope.before)).rowwise().norm();
  double greatest = 0.0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    greatest = hasFace[v] ? std::max(greatest, moved[v]) : greatest;
  }
  const double share = greatest / boundsOf(FacePositions(mesh.mesh()).points()).diagonal();
  // Below a millionth it is rounding, and nothing that anybody could see.
  scope.remarks.push_back(share < 1e-6 ? std::string("The edits are kept, and the shape is the same.")
                                       : format("The edits are kept; the shape differs by at most {}, {} % of its "
                                                "diagonal.",
                                                figures(greatest), figures(100.0 * share)));
}

}  // namespace

Project applied(const EditScope& scope, const Place& edit) {
  requireUsable(edit);
  const Project& before = scope.before;
  const PlacementResult placement = place(scope, edit);
  scope.remarks.insert(scope.remarks.end(), placement.remarks.begin(), placement.remarks.end());
  Project after = before;
  after.placement = edit.options;
  ControlSet edited;
  edited.basis = edit.options.basis;
  edited.master = placement.master;
  const Level finest = finestLevel(scope, placement.finest, after.nextId);
  edited.levels =
      buildLevels(finest, levelCountFor(scope, edit, finest.size()), after.nextId, edit.options.regions);
  addCoarserSurvivors(scope, before.controls, edited);
  if (edit.keepEdits) {
    carryAlong(scope, edited);
  }
  after.controls = std::move(edited);
  after.controls =
      withStructure({after, scope.workspace, scope.progress, scope.remarks}, after.controls).controls;
  if (edit.keepEdits) {
    remarkDifference(scope, after);
    return after;
  }
  // A reset that leaves locked points where they are.
  return applied({after, scope.workspace, scope.progress, scope.remarks}, Reset{});
}

}  // namespace pbffd
