#include "ui/controllers/rotate_gesture.h"

#include "ui/controllers/drag_math.h"

#include <QCoreApplication>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace pbffd::ui {
namespace {

constexpr double snapDegrees = 5.0;
constexpr double preciseSnapDegrees = 1.0;
/// A ring turned further than this from the view (cosine) is dragged along its tangent instead.
constexpr double leastRingCosine = 0.25;
constexpr double degreesOfRadian = 180.0 / std::numbers::pi;

}  // namespace

RotateGesture::RotateGesture(GestureSubject subject, AxisLock lock, const QPointF& start, Manner manner)
    : TransformGesture(std::move(subject), lock, start), manner_(manner), followed_(start) {}

Vec3 RotateGesture::axisOfLock(const Projection& projection) const {
  if (lock().kind == AxisLock::Kind::axis) {
    return lockAxes().col(lock().axis);
  }
  return projection.lens().toWorld.col(2);
}

void RotateGesture::lockChanged() {
  manner_ = Manner::ring;
  swept_ = 0.0;
  followed_ = start();
}

void RotateGesture::sweep(const Projection& projection) {
  const Guide plane{subject().pivot, axis_};
  const PickRay toPivot = {projection.lens().eye, projection.lens().toWorld.col(2)};
  const Vec3 view =
      projection.lens().orthographic ? toPivot.direction : Vec3((toPivot.origin - plane.origin).normalized());
  const PickRay before = projection.rayThrough(followed_.x(), followed_.y());
  const PickRay now = projection.rayThrough(cursor().x(), cursor().y());
  const auto first = meetsPlane(before, plane);
  const auto second = meetsPlane(now, plane);
  if (std::abs(axis_.dot(view)) > leastRingCosine && first && second) {
    swept_ += angleBetween(plane, *first, *second);
  } else {
    // The near side of the ring runs across the screen in this direction.
    const Vec3 tangent = axis_.cross(view);
    const Vec3 at = projection.toScreen(plane.origin);
    const Vec3 ahead = projection.toScreen(plane.origin + projection.pixelSizeAt(plane.origin) * tangent);
    const QPointF along(ahead.x() - at.x(), ahead.y() - at.y());
    swept_ += QPointF::dotProduct(cursor() - followed_, along) / GizmoSizes::ring;
  }
  followed_ = cursor();
}

void RotateGesture::rollBall(const Projection& projection) {
  const QPointF by = cursor() - start();
  const Mat3& view = projection.lens().toWorld;
  const Vec3 across = by.x() * view.col(1) + by.y() * view.col(0);
  swept_ = std::hypot(by.x(), by.y()) / GizmoSizes::ring;
  if (across.norm() > 0.0) {
    axis_ = across.normalized();
  }
}

void RotateGesture::follow(const Projection& projection) {
  if (manner_ == Manner::ball) {
    rollBall(projection);
  } else {
    axis_ = axisOfLock(projection);
    sweep(projection);
  }
  degrees_ = swept_ * degreesOfRadian;
  if (const auto number = typed(0)) {
    degrees_ = *number;
  } else if (snaps()) {
    degrees_ = snapped(degrees_, isPrecise() ? preciseSnapDegrees : snapDegrees);
  }
}

Edit RotateGesture::edit() const {
  Transform transform;
  transform.where = {subject().level, subject().points};
  transform.spread.master = subject().isWholeLevel && !subject().eachItsOwn;
  transform.pivot = subject().pivot;
  transform.eachItsOwn = subject().eachItsOwn;
  if (transform.eachItsOwn) {
    transform.pivot.reset();
  }
  transform.rotationAxis = axis_;
  transform.degrees = degrees_;
  return transform;
}

Gizmo RotateGesture::gizmo(const Projection& projection) const {
  Gizmo gizmo;
  gizmo.kind = GizmoKind::rotate;
  gizmo.center = subject().pivot;
  gizmo.axes = lockAxes();
  if (manner_ == Manner::ball) {
    gizmo.dragged = GizmoPart::ball;
    return gizmo;
  }
  gizmo.dragged = lock().kind == AxisLock::Kind::axis ? lock().part() : GizmoPart::view;
  const auto from = meetsPlane(projection.rayThrough(start().x(), start().y()), {subject().pivot, axis_});
  const Vec3 towards = from ? Vec3(*from - subject().pivot) : axis_.unitOrthogonal();
  gizmo.pie = Gizmo::Pie{axis_, towards.norm() > 0.0 ? Vec3(towards.normalized()) : axis_.unitOrthogonal(),
                         degrees_ / degreesOfRadian};
  return gizmo;
}

QStringList RotateGesture::letters() const {
  return lock().kind == AxisLock::Kind::axis ? QStringList{axisLetter(lock().axis)} : QStringList{};
}

QStringList RotateGesture::amounts() const {
  const QString sign = degrees_ < 0.0 ? QStringLiteral("\u2212") : QStringLiteral("+");
  return {sign + QString::number(std::abs(degrees_), 'f', 1) + QStringLiteral("\u00b0")};
}

QString RotateGesture::title() const {
  if (manner_ == Manner::ball) {
    return QCoreApplication::translate("RotateGesture", "Rotating freely");
  }
  if (lock().kind != AxisLock::Kind::axis) {
    return QCoreApplication::translate("RotateGesture", "Rotating in the view plane");
  }
  const bool isLocal = lock().space == AxisLock::Space::local;
  return (isLocal ? QCoreApplication::translate("RotateGesture", "Rotating about local %1")
                  : QCoreApplication::translate("RotateGesture", "Rotating about %1"))
      .arg(axisLetter(lock().axis));
}

}  // namespace pbffd::ui
