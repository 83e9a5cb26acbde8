#pragma once

#include "ui/views/camera.h"
#include "ui/views/color.h"
#include "ui/views/gizmo_actor.h"
#include "ui/views/hierarchy_actor.h"
#include "ui/views/mesh_actor.h"
#include "ui/views/point_actor.h"
#include "ui/views/region_actor.h"
#include "ui/views/stroke_actor.h"

#include <memory>

#include <vtkNew.h>

class vtkCamera;
class vtkRenderWindow;
class vtkRenderer;

namespace pbffd::ui {

/// The layers of the view and the actors in them, from back to front:
/// background and ghost; the surface, its edges and the ground; regions, the hierarchy, points and the gizmo,
/// which see the depth of the surface. All positions relative to one origin.
class Scene {
 public:
  explicit Scene(vtkRenderWindow& window);
  ~Scene();

  struct Background {
    Rgba bottom{};
    Rgba top{};
  };
  void setBackground(const Background& background);

  /// Translucent surfaces need peeling, which costs; the caller says when there are any.
  void setPeeling(bool peels);
  /// Smoothing of the surface's borders.
  void setSmoothing(bool smooths);
  void setPixelRatio(double ratio);
  /// `camera` in view space.
  void setCamera(const Camera& camera, const Projection& projection);

  MeshActor& mesh() { return *mesh_; }
  GhostActor& ghost() { return *ghost_; }
  StrokeActor& grid() { return *grid_; }
  RegionActor& regions() { return *regions_; }
  HierarchyActor& hierarchy() { return *hierarchy_; }
  PointActor& points() { return *points_; }
  GizmoActor& gizmo() { return *gizmo_; }

 private:
  vtkNew<vtkCamera> camera_;
  vtkNew<vtkRenderer> back_;
  vtkNew<vtkRenderer> surface_;
  vtkNew<vtkRenderer> front_;
  std::unique_ptr<MeshActor> mesh_;
  std::unique_ptr<GhostActor> ghost_;
  std::unique_ptr<StrokeActor> grid_;
  std::unique_ptr<RegionActor> regions_;
  std::unique_ptr<HierarchyActor> hierarchy_;
  std::unique_ptr<PointActor> points_;
  std::unique_ptr<GizmoActor> gizmo_;
};

}  // namespace pbffd::ui
