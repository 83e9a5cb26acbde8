#include "ui/views/viewport.h"

#include "ui/views/axis_triad.h"
#include "ui/views/camera_controller.h"
#include "ui/views/overlays.h"
#include "ui/views/scene.h"
#include "ui/views/scene_content.h"
#include "ui/views/vtk_widget.h"

#include <QVBoxLayout>

#include <algorithm>
#include <limits>
#include <numbers>

#include <vtkGenericOpenGLRenderWindow.h>

namespace pbffd::ui {
namespace {

constexpr double pickRadius = 10.0;
/// The share of the view that framing fills.
constexpr double fillAll = 0.80;
constexpr double fillSelection = 0.55;
/// Where the camera stands at first: the three-quarter view.
constexpr double firstYaw = 30.0;
constexpr double firstPitch = 16.0;
constexpr int overlayMargin = 12;

constexpr double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

}  // namespace

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
  bool framesNextMesh = true;
};

Viewport::Viewport(Document& document, ViewState& view, Theme& theme, QWidget* parent)
    : QWidget(parent), parts_(std::make_unique<Parts>(document, view, theme, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(parts_->widget);
  setFocusProxy(parts_->widget);
  parts_->widget->setAccessibleName(tr("View of the mesh"));
  parts_->nameTag->setObjectName(QStringLiteral("nameTag"));
  parts_->readOut->setObjectName(QStringLiteral("readOut"));
  parts_->camera.turnTo(radians(firstYaw), radians(firstPitch));
  parts_->cameraController = new CameraController(*this, view);
  connectSources();
}

Viewport::~Viewport() {
  // The actors release what they hold on the graphics card while the widget's context is still there.
  delete parts_->widget;
  parts_->scene.reset();
}

void Viewport::connectSources() {
  const auto refresh = [this](unsigned stale) {
    parts_->content.documentChanged();
    parts_->content.invalidate(stale);
    requestFrame();
  };
  Document& document = parts_->document;
  connect(&document, &Document::opened, this, [this, refresh] {
    parts_->framesNextMesh = true;
    parts_->content.setHoveredPoint(0);
    refresh(SceneContent::everything);
  });
  connect(&document, &Document::changed, this, [refresh](const ProjectChanges& what) {
    const bool moves = what.mesh || what.structure || what.rest || what.poses;
    refresh(moves ? SceneContent::positions | SceneContent::points | SceneContent::regions
                  : SceneContent::points);
  });
  connect(&document.selection(), &Selection::changed, this,
          [refresh] { refresh(SceneContent::points | SceneContent::regions); });
  connect(&document.selection(), &Selection::levelChanged, this,
          [refresh] { refresh(SceneContent::points | SceneContent::regions); });
  connect(&parts_->view, &ViewState::changed, this, [this, refresh] {
    parts_->camera.orthographic = parts_->view.isOrthographic();
    refresh(SceneContent::display | SceneContent::points | SceneContent::regions);
  });
  connect(&parts_->theme, &Theme::changed, this, [refresh] { refresh(SceneContent::everything); });
  connect(parts_->widget, &VtkWidget::aboutToRender, this, &Viewport::prepareFrame);
  connect(parts_->widget, &VtkWidget::rendered, this, &Viewport::rendered);
  connect(parts_->triad, &AxisTriad::sideChosen, this, [this](int axis, bool positive) {
    constexpr Side sides[3][2] = {
        {Side::left, Side::right}, {Side::bottom, Side::top}, {Side::back, Side::front}};
    lookFrom(sides[axis][positive ? 1 : 0]);
  });
}

QWidget* Viewport::surface() const {
  return parts_->widget;
}

void Viewport::requestFrame() {
  // Now, not while painting: what moves over the view then shares its frame.
  placeOverlays();
  parts_->widget->update();
}

void Viewport::prepareFrame() {
  Parts& p = *parts_;
  const bool isOtherMesh = p.content.bringUpToDate(*p.scene);
  if (isOtherMesh && p.framesNextMesh && p.content.surface().mesh() != nullptr) {
    p.framesNextMesh = false;
    frameAll();
  }
  const Vec3& origin = p.content.origin();
  Camera camera = p.camera;
  camera.focus -= origin;
  Extent extent = p.content.extent();
  extent.center -= origin;
  const Projection projection = camera.projection(width(), height(), extent);
  p.scene->setPixelRatio(devicePixelRatioF());
  p.scene->setSmoothing(true);
  p.scene->setCamera(camera, projection);
  const Projection::Lens& lens = projection.lens();
  const double perUnit = 0.5 * height() / lens.halfHeight;
  p.scene->mesh().setPixelsPerUnit(perUnit,
                                   perUnit / (lens.orthographic ? 1.0 : std::max(lens.nearDepth, 1e-12)));
  Gizmo gizmo = p.gizmo;
  gizmo.center -= origin;
  p.scene->gizmo().draw(gizmo, projection);
}

void Viewport::frameAll() {
  Parts& p = *parts_;
  const SurfaceBuffers& buffers = p.content.surface().buffers();
  if (p.content.surface().mesh() == nullptr) {
    return;
  }
  const Vec3 origin = p.content.origin();
  const auto eachVertex = [&](const std::function<void(const Vec3&)>& see) {
    const std::vector<float>& positions = *buffers.positions;
    for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
      see(origin + Vec3(positions[i], positions[i + 1], positions[i + 2]));
    }
  };
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  eachVertex([&](const Vec3& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  });
  const double aspect = static_cast<double>(std::max(width(), 1)) / std::max(height(), 1);
  p.camera.frame(0.5 * (low + high), eachVertex, aspect, fillAll);
  setCamera(p.camera);
}

void Viewport::frameSelection() {
  Parts& p = *parts_;
  const Selection& selection = p.document.selection();
  const auto& levels = p.document.shown().controls.levels;
  const Index place = p.document.editLevel();
  std::vector<Vec3> corners;
  if (place >= 0 && place < static_cast<Index>(levels.size())) {
    for (const ControlPoint& point : levels[place]) {
      if (selection.contains(point.id)) {
        for (int axis = 0; axis < 3; ++axis) {
          corners.push_back(point.pose.center + point.pose.axes.col(axis));
          corners.push_back(point.pose.center - point.pose.axes.col(axis));
        }
      }
    }
  }
  if (corners.empty()) {
    frameAll();
    return;
  }
  Vec3 center = Vec3::Zero();
  for (const Vec3& corner : corners) {
    center += corner / static_cast<double>(corners.size());
  }
  const auto eachCorner = [&](const std::function<void(const Vec3&)>& see) {
    std::for_each(corners.begin(), corners.end(), see);
  };
  const double aspect = static_cast<double>(std::max(width(), 1)) / std::max(height(), 1);
  p.camera.frame(center, eachCorner, aspect, fillSelection);
  setCamera(p.camera);
}

void Viewport::lookFrom(Side side) {
  const double quarter = 0.5 * std::numbers::pi;
  Camera& camera = parts_->camera;
  switch (side) {
    case Side::front:
      camera.turnTo(0.0, 0.0);
      break;
    case Side::back:
      camera.turnTo(2.0 * quarter, 0.0);
      break;
    case Side::right:
      camera.turnTo(quarter, 0.0);
      break;
    case Side::left:
      camera.turnTo(-quarter, 0.0);
      break;
    case Side::top:
      camera.turnTo(0.0, quarter);
      break;
    case Side::bottom:
      camera.turnTo(0.0, -quarter);
      break;
  }
  setCamera(camera);
}

const Camera& Viewport::camera() const {
  return parts_->camera;
}

void Viewport::setCamera(const Camera& camera) {
  parts_->camera = camera;
  parts_->triad->setAxes(camera.axes());
  requestFrame();
  Q_EMIT cameraChanged();
}

void Viewport::orbitBy(double yawDegrees, double pitchDegrees) {
  Camera camera = parts_->camera;
  camera.orbit(camera.focus, radians(yawDegrees), radians(pitchDegrees));
  setCamera(camera);
}

QImage Viewport::picture() {
  return parts_->widget->grabFramebuffer();
}

Projection Viewport::projection() const {
  return parts_->camera.projection(parts_->widget->width(), parts_->widget->height(), parts_->content.extent());
}

Vec3 Viewport::projected(const Vec3& world) const {
  return projection().toScreen(world);
}

PickRay Viewport::rayThrough(const QPointF& position) const {
  return projection().rayThrough(position.x(), position.y());
}

std::optional<SurfaceHit> Viewport::surfaceAt(const QPointF& position) const {
  const SurfaceStore& surface = parts_->content.surface();
  if (surface.mesh() == nullptr || surface.mesh() != parts_->document.shown().mesh) {
    return std::nullopt;
  }
  PickRay ray = rayThrough(position);
  const Vec3 eye = ray.origin;
  ray.origin -= surface.origin();
  const auto pick = pickSurface(*surface.buffers().positions, *surface.buffers().triangles, ray);
  if (!pick) {
    return std::nullopt;
  }
  return SurfaceHit{eye + pick->distance * ray.direction, pick->triangle};
}

std::vector<PointId> Viewport::pointsAt(const QPointF& position) const {
  return pickPoints(parts_->content.pickablePoints(), projection(), position, pickRadius);
}

std::vector<PointId> Viewport::pointsIn(const QRectF& box) const {
  return pickPointsIn(parts_->content.pickablePoints(), projection(), box);
}

double Viewport::pixelSizeAt(const Vec3& world) const {
  return projection().pixelSizeAt(world);
}

Vec3 Viewport::viewDirection() const {
  return parts_->camera.forward();
}

Vec3 Viewport::upDirection() const {
  return parts_->camera.up();
}

Vec3 Viewport::rightDirection() const {
  return parts_->camera.right();
}

void Viewport::setHoveredPoint(PointId point) {
  if (point != parts_->content.hoveredPoint()) {
    parts_->content.setHoveredPoint(point);
    requestFrame();
  }
}

PointId Viewport::hoveredPoint() const {
  return parts_->content.hoveredPoint();
}

void Viewport::setGizmo(const Gizmo& gizmo) {
  parts_->gizmo = gizmo;
  requestFrame();
}

GizmoPart Viewport::gizmoPartAt(const QPointF& position) const {
  const Projection seen = projection();
  return GizmoShape(parts_->gizmo, seen).partAt(position.x(), position.y());
}

void Viewport::setRubberBand(const QRectF& box) {
  parts_->rubberBand->setBox(box);
}

void Viewport::setReadOut(const ReadOut& readOut) {
  parts_->readOutText = readOut;
  parts_->readOut->setText(readOut.value, readOut.hint, readOut.color);
  placeOverlays();
}

double Viewport::gridSpacing() const {
  return parts_->content.gridSpacing();
}

void Viewport::placeOverlays() {
  Parts& p = *parts_;
  const Projection seen = projection();
  p.triad->move(overlayMargin, p.widget->height() - p.triad->height() - overlayMargin);
  if (!p.readOutText.value.isEmpty()) {
    const Vec3 at = seen.toScreen(p.readOutText.anchor);
    p.readOut->placeBeside(QPointF(at.x(), at.y()), p.widget->size());
  }
  const PointId hovered = p.content.hoveredPoint();
  const auto& levels = p.document.shown().controls.levels;
  const Index place = p.document.editLevel();
  if (hovered == 0 || place < 0 || place >= static_cast<Index>(levels.size())) {
    p.nameTag->hide();
    return;
  }
  if (const auto row = levels[place].find(hovered)) {
    const ControlPoint& point = levels[place][*row];
    const Vec3 at = seen.toScreen(point.pose.center);
    p.nameTag->setPoint(point);
    p.nameTag->placeBeside(QPointF(at.x(), at.y()), p.widget->size());
  }
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeOverlays();
}

}  // namespace pbffd::ui
