#include "ui/views/scene.h"

#include <numbers>

#include <vtkCamera.h>
#include <vtkCullerCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace pbffd::ui {
namespace {

/// Layers of translucent surface that are told apart.
constexpr int mostPeels = 6;

}  // namespace

Scene::Scene(vtkRenderWindow& window) {
  window.SetNumberOfLayers(3);
  window.AlphaBitPlanesOn();
  int layer = 0;
  for (vtkRenderer* renderer : {back_.Get(), surface_.Get(), front_.Get()}) {
    renderer->SetLayer(layer++);
    renderer->SetActiveCamera(camera_);
    renderer->AutomaticLightCreationOff();
    // Bounds are never known here (see PassMapper), so nothing may be culled by them.
    renderer->GetCullers()->RemoveAllItems();
    window.AddRenderer(renderer);
  }
  back_->GradientBackgroundOn();
  surface_->SetMaximumNumberOfPeels(mostPeels);
  surface_->SetOcclusionRatio(0.0);
  front_->PreserveDepthBufferOn();

  ghost_ = std::make_unique<GhostActor>(*back_);
  mesh_ = std::make_unique<MeshActor>(*surface_);
  grid_ = std::make_unique<StrokeActor>(*surface_);
  regions_ = std::make_unique<RegionActor>(*front_);
  hierarchy_ = std::make_unique<HierarchyActor>(*front_);
  points_ = std::make_unique<PointActor>(*front_);
  gizmo_ = std::make_unique<GizmoActor>(*front_);
}

Scene::~Scene() = default;

void Scene::setBackground(const Background& background) {
  back_->SetBackground(background.bottom[0], background.bottom[1], background.bottom[2]);
  back_->SetBackground2(background.top[0], background.top[1], background.top[2]);
}

void Scene::setPeeling(bool peels) {
  surface_->SetUseDepthPeeling(peels);
}

void Scene::setSmoothing(bool smooths) {
  surface_->SetUseFXAA(smooths);
}

void Scene::setPixelRatio(double ratio) {
  mesh_->setPixelRatio(ratio);
  grid_->setPixelRatio(ratio);
  regions_->setPixelRatio(ratio);
  hierarchy_->setPixelRatio(ratio);
  points_->setPixelRatio(ratio);
  gizmo_->setPixelRatio(ratio);
}

void Scene::setCamera(const Camera& camera, const Projection& projection) {
  const Projection::Lens& lens = projection.lens();
  const Vec3 up = camera.up();
  camera_->SetPosition(lens.eye.data());
  camera_->SetFocalPoint(camera.focus.data());
  camera_->SetViewUp(up.data());
  camera_->SetViewAngle(camera.fieldOfView * 180.0 / std::numbers::pi);
  camera_->SetParallelProjection(lens.orthographic);
  camera_->SetParallelScale(lens.halfHeight);
  camera_->SetClippingRange(lens.nearDepth, lens.farDepth);
  regions_->setLens(lens);
}

}  // namespace pbffd::ui
