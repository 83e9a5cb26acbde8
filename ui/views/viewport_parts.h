#pragma once

#include "ui/views/axis_triad.h"
#include "ui/views/camera_controller.h"
#include "ui/views/drag_detail.h"
#include "ui/views/overlays.h"
#include "ui/views/scene.h"
#include "ui/views/scene_content.h"
#include "ui/views/viewport.h"
#include "ui/views/vtk_widget.h"

#include <numbers>

#include <vtkGenericOpenGLRenderWindow.h>

namespace pbffd::ui {

constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

/// What a viewport is made of; for its own source files alone.
struct Viewport::Parts {
  Parts(Document& openDocument, ViewState& viewState, Theme& currentTheme, QWidget* parent)
      : document(openDocument),
        view(viewState),
        theme(currentTheme),
        widget(new VtkWidget(parent)),
        content(openDocument, viewState, currentTheme),
        scene(std::make_unique<Scene>(*widget->renderWindow())),
        triad(new AxisTriad(currentTheme, widget)),
        nameTag(new NameTag(currentTheme, widget)),
        readOut(new ReadOutBox(currentTheme, widget)),
        rubberBand(new RubberBand(currentTheme, widget)) {}

  Document& document;
  ViewState& view;
  Theme& theme;
  VtkWidget* widget;
  SceneContent content;
  std::unique_ptr<Scene> scene;
  Camera camera;
  Gizmo gizmo;
  ReadOut readOutText;
  AxisTriad* triad;
  NameTag* nameTag;
  ReadOutBox* readOut;
  RubberBand* rubberBand;
  CameraController* cameraController = nullptr;
  DragDetail* detail = nullptr;
  bool framesNextMesh = true;
  int coveredLeft = 0;
  int coveredTop = 0;
};

}  // namespace pbffd::ui
