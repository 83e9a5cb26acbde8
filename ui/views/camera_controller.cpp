#include "ui/views/camera_controller.h"

#include "ui/document/view_state.h"
#include "ui/views/viewport.h"

#include <QInputDevice>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QWheelEvent>

#include <cmath>

namespace pbffd::ui {
namespace {

constexpr double degreesPerPixel = 0.4;
constexpr double degreesPerKey = 15.0;
/// A notch of the wheel is 120.
constexpr double zoomPerWheelUnit = 0.0012;
constexpr double zoomPerPixel = 0.006;
constexpr int wheelPauseMilliseconds = 400;

}  // namespace

CameraController::CameraController(Viewport& viewport, ViewState& view)
    : QObject(&viewport), viewport_(viewport), view_(view) {
  viewport.surface()->installEventFilter(this);
  wheelPause_.setSingleShot(true);
  wheelPause_.setInterval(wheelPauseMilliseconds);
  connect(&wheelPause_, &QTimer::timeout, this, &CameraController::stopped);
}

bool CameraController::eventFilter(QObject*, QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return release(*static_cast<QMouseEvent*>(event));
    case QEvent::Wheel:
      return wheel(*static_cast<QWheelEvent*>(event));
    case QEvent::NativeGesture:
      return gesture(*static_cast<QNativeGestureEvent*>(event));
    case QEvent::KeyPress:
      return key(*static_cast<QKeyEvent*>(event));
    default:
      return false;
  }
}

Vec3 CameraController::pivotAt(const QPointF& position) const {
  if (const auto hit = viewport_.surfaceAt(position)) {
    return hit->position;
  }
  const PickRay ray = viewport_.rayThrough(position);
  const Camera& camera = viewport_.camera();
  const Vec3 forward = camera.forward();
  return ray.origin + (camera.focus - ray.origin).dot(forward) / ray.direction.dot(forward) * ray.direction;
}

bool CameraController::press(const QMouseEvent& event) {
  const bool isAltLeft = event.button() == Qt::LeftButton && event.modifiers().testFlag(Qt::AltModifier);
  if (drag_ != Drag::none || (event.button() != Qt::MiddleButton && !isAltLeft)) {
    return false;
  }
  drag_ = Drag::orbit;
  if (event.modifiers().testFlag(Qt::ShiftModifier)) {
    drag_ = Drag::pan;
  } else if (event.modifiers().testFlag(Qt::ControlModifier)) {
    drag_ = Drag::zoom;
  }
  button_ = event.button();
  last_ = event.position();
  pivot_ = pivotAt(last_);
  return true;
}

bool CameraController::move(const QMouseEvent& event) {
  if (drag_ == Drag::none) {
    return false;
  }
  const QPointF by = event.position() - last_;
  last_ = event.position();
  Camera camera = viewport_.camera();
  if (drag_ == Drag::orbit) {
    const double scale = -degreesPerPixel * M_PI / 180.0;
    camera.orbit(pivot_, scale * by.x(), -scale * by.y());
  } else if (drag_ == Drag::pan) {
    const double pixel = viewport_.pixelSizeAt(pivot_);
    camera.moveBy(pixel * (by.y() * camera.up() - by.x() * camera.right()));
    pivot_ += pixel * (by.y() * camera.up() - by.x() * camera.right());
  } else {
    camera.zoom(pivot_, std::exp(zoomPerPixel * by.y()));
  }
  viewport_.setCamera(camera);
  return true;
}

bool CameraController::release(const QMouseEvent& event) {
  if (drag_ == Drag::none || event.button() != button_) {
    return false;
  }
  drag_ = Drag::none;
  Q_EMIT stopped();
  return true;
}

void CameraController::zoomAt(const QPointF& position, double factor) {
  if (!wheelPause_.isActive() || wheelAt_ != position) {
    pivot_ = pivotAt(position);
  }
  wheelPause_.start();
  wheelAt_ = position;
  Camera camera = viewport_.camera();
  camera.zoom(pivot_, factor);
  viewport_.setCamera(camera);
}

bool CameraController::wheel(const QWheelEvent& event) {
  if (drag_ != Drag::none) {
    return true;
  }
  const bool isTrackpad =
      event.device() != nullptr && event.device()->type() == QInputDevice::DeviceType::TouchPad;
  if (isTrackpad && !event.modifiers().testFlag(Qt::ControlModifier)) {
    const QPointF by =
        event.pixelDelta().isNull() ? QPointF(event.angleDelta()) / 4.0 : QPointF(event.pixelDelta());
    wheelPause_.start();
    wheelAt_ = {-1.0, -1.0};  // a zoom right after it takes a pivot of its own
    viewport_.orbitBy(-degreesPerPixel * by.x(), degreesPerPixel * by.y());
    return true;
  }
  // With Alt held, Qt gives the wheel as a sideways one.
  const int turned = event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
  zoomAt(event.position(), std::exp(-zoomPerWheelUnit * turned));
  return true;
}

bool CameraController::gesture(const QNativeGestureEvent& event) {
  if (event.gestureType() != Qt::ZoomNativeGesture) {
    return false;
  }
  zoomAt(event.position(), 1.0 / std::max(0.1, 1.0 + event.value()));
  return true;
}

bool CameraController::key(const QKeyEvent& event) {
  const bool isAlt = event.modifiers().testFlag(Qt::AltModifier);
  const bool isOpposite = event.modifiers().testFlag(Qt::ControlModifier);
  const bool isNumber = isAlt || event.modifiers().testFlag(Qt::KeypadModifier);
  switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
      if (isAlt) {
        viewport_.orbitBy(event.key() == Qt::Key_Left ? -degreesPerKey : degreesPerKey, 0.0);
      }
      return isAlt;
    case Qt::Key_Up:
    case Qt::Key_Down:
      if (isAlt) {
        viewport_.orbitBy(0.0, event.key() == Qt::Key_Up ? degreesPerKey : -degreesPerKey);
      }
      return isAlt;
    case Qt::Key_Home:
      viewport_.frameAll();
      return true;
    case Qt::Key_F:
      viewport_.frameSelection();
      return true;
    case Qt::Key_1:
    case Qt::Key_3:
    case Qt::Key_7:
      if (isNumber) {
        using Side = Viewport::Side;
        const Side front = isOpposite ? Side::back : Side::front;
        const Side right = isOpposite ? Side::left : Side::right;
        const Side top = isOpposite ? Side::bottom : Side::top;
        viewport_.lookFrom(event.key() == Qt::Key_1 ? front : event.key() == Qt::Key_3 ? right : top);
      }
      return isNumber;
    case Qt::Key_5:
      if (isNumber) {
        view_.setOrthographic(!view_.isOrthographic());
      }
      return isNumber;
    default:
      return false;
  }
}

}  // namespace pbffd::ui
