#include "ui/views/viewport_parts.h"

#include <QVBoxLayout>

#include <algorithm>

namespace pbffd::ui {
namespace {

constexpr double pickRadius = 10.0;
/// Where the camera stands at first: the three-quarter view.
constexpr double firstYaw = 30.0;
constexpr double firstPitch = 16.0;
constexpr int overlayMargin = 12;

}  // namespace

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
  parts_->detail = new DragDetail(document, this);
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
  connect(parts_->widget, &VtkWidget::measured, parts_->detail, &DragDetail::drawn);
  connect(parts_->widget, &VtkWidget::rendered, this, &Viewport::rendered);
  connect(parts_->detail, &DragDetail::simplifiedChanged, this, &Viewport::simplifiedChanged);
  connect(parts_->detail, &DragDetail::failed, this, &Viewport::remarked);
  // The whole mesh again.
  connect(&document, &Document::previewEnded, this, &Viewport::requestFrame);
  connect(parts_->cameraController, &CameraController::stopped, this, &Viewport::requestFrame);
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
  p.detail->prepare(p.scene->mesh(), p.content.surface(),
                    {p.document.isPreviewing() || p.cameraController->isMoving(), p.content.surfaceRevision(),
                     p.view.displayMode(), p.widget->size()});
  p.widget->setMeasured(p.detail->isMeasuring());
  const Vec3& origin = p.content.origin();
  Camera camera = p.camera;
  camera.focus -= origin;
  Extent extent = p.content.extent();
  extent.center -= origin;
  const Projection projection = camera.projection(width(), height(), extent);
  p.scene->setPixelRatio(devicePixelRatioF());
  p.scene->setSmoothing(!p.detail->isSimplified());
  p.scene->setCamera(camera, projection);
  const Projection::Lens& lens = projection.lens();
  const double perUnit = 0.5 * height() / lens.halfHeight;
  p.scene->mesh().setPixelsPerUnit(perUnit,
                                   perUnit / (lens.orthographic ? 1.0 : std::max(lens.nearDepth, 1e-12)));
  Gizmo gizmo = p.gizmo;
  gizmo.center -= origin;
  p.scene->gizmo().draw(gizmo, projection);
}

QImage Viewport::picture() {
  return parts_->widget->grabFramebuffer();
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

bool Viewport::isSimplified() const {
  return parts_->detail->isSimplified();
}

bool Viewport::canSimplify() const {
  return parts_->detail->canSimplify();
}

void Viewport::setFrameBudget(double seconds) {
  parts_->detail->setFrameBudget(seconds);
}

double Viewport::gridSpacing() const {
  return parts_->content.gridSpacing();
}

void Viewport::placeOverlays() {
  Parts& p = *parts_;
  const Projection seen = projection();
  p.triad->move(overlayMargin, p.widget->height() - p.triad->height() - overlayMargin);
  const QRect room = p.widget->rect().adjusted(p.coveredLeft, p.coveredTop, 0, 0);
  if (!p.readOutText.value.isEmpty()) {
    const Vec3 at = seen.toScreen(p.readOutText.anchor);
    p.readOut->placeBeside(QPointF(at.x(), at.y()), room);
  }
  const PointId hovered = p.content.hoveredPoint();
  const auto& levels = p.document.shown().controls.levels;
  const Index place = p.document.editLevel();
  const bool isLevel = place >= 0 && place < static_cast<Index>(levels.size());
  const auto row = isLevel ? levels[place].find(hovered) : std::nullopt;
  if (!row) {
    p.nameTag->hide();
    return;
  }
  const ControlPoint& point = levels[place][*row];
  const Vec3 at = seen.toScreen(point.pose.center);
  p.nameTag->setPoint(point);
  p.nameTag->placeBeside(QPointF(at.x(), at.y()), room);
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeOverlays();
}

}  // namespace pbffd::ui
