#include "ui/controllers/move_gesture.h"

#include "ui/controllers/drag_math.h"

#include <QCoreApplication>

namespace pbffd::ui {

std::vector<int> MoveGesture::axes() const {
  std::vector<int> used;
  for (int axis = 0; axis < 3; ++axis) {
    const bool isLockedAxis = axis == lock().axis;
    if (lock().kind == AxisLock::Kind::free || (lock().kind == AxisLock::Kind::axis) == isLockedAxis) {
      used.push_back(axis);
    }
  }
  return used;
}

std::optional<double> MoveGesture::alongAxis(const Projection& projection, const QPointF& at) const {
  const Guide line{subject().pivot, lockAxes().col(lock().axis)};
  const double reach = GizmoSizes::length * projection.pixelSizeAt(line.origin);
  const Vec3 from = projection.toScreen(line.origin);
  const Vec3 ahead = projection.toScreen(line.origin + reach * line.direction);
  const QPointF along(ahead.x() - from.x(), ahead.y() - from.y());
  const double squared = QPointF::dotProduct(along, along);
  if (squared < 1.0) {
    return std::nullopt;
  }
  // What the cursor does across the axis, as it is seen, does not count.
  const QPointF start(from.x(), from.y());
  const QPointF onAxis = start + QPointF::dotProduct(at - start, along) / squared * along;
  return nearestOnLine(projection.rayThrough(onAxis.x(), onAxis.y()), line);
}

Vec3 MoveGesture::shiftByCursor(const Projection& projection) const {
  if (lock().kind == AxisLock::Kind::axis) {
    const auto first = alongAxis(projection, start());
    const auto second = alongAxis(projection, cursor());
    return first && second ? Vec3((*second - *first) * lockAxes().col(lock().axis)) : Vec3::Zero();
  }
  const PickRay from = projection.rayThrough(start().x(), start().y());
  const PickRay to = projection.rayThrough(cursor().x(), cursor().y());
  const Vec3& pivot = subject().pivot;
  const bool isView = lock().kind == AxisLock::Kind::free;
  const Vec3 normal = isView ? Vec3(projection.lens().toWorld.col(2)) : Vec3(lockAxes().col(lock().axis));
  const auto first = meetsPlane(from, {pivot, normal});
  const auto second = meetsPlane(to, {pivot, normal});
  return first && second ? Vec3(*second - *first) : Vec3::Zero();
}

void MoveGesture::snapAlong(const Mat3& frame, double step) {
  Vec3 along = frame.transpose() * shift_;
  for (const int axis : axes()) {
    along[axis] = snapped(along[axis], step);
  }
  shift_ = frame * along;
}

void MoveGesture::follow(const Projection& projection) {
  const Mat3 frame = lock().kind == AxisLock::Kind::free ? Mat3(Mat3::Identity()) : lockAxes();
  if (!entry().isEmpty()) {
    shift_.setZero();
    const std::vector<int> used = axes();
    for (std::size_t i = 0; i < used.size(); ++i) {
      shift_ += typed(static_cast<int>(i)).value_or(0.0) * frame.col(used[i]);
    }
    return;
  }
  shift_ = shiftByCursor(projection);
  if (snaps()) {
    snapAlong(frame, moveStep(subject().size) * (isPrecise() ? 0.1 : 1.0));
  }
}

Edit MoveGesture::edit() const {
  Move move;
  move.where = {subject().level, subject().points};
  move.by = {shift_};
  move.spread.master = subject().isWholeLevel;
  return move;
}

Gizmo MoveGesture::gizmo(const Projection&) const {
  Gizmo gizmo;
  gizmo.kind = GizmoKind::move;
  gizmo.center = subject().pivot + shift_;
  gizmo.axes = lockAxes();
  gizmo.dragged = lock().part();
  return gizmo;
}

QStringList MoveGesture::letters() const {
  QStringList names;
  for (const int axis : axes()) {
    names << axisLetter(axis);
  }
  return names;
}

QStringList MoveGesture::amounts() const {
  const Mat3 frame = lock().kind == AxisLock::Kind::free ? Mat3(Mat3::Identity()) : lockAxes();
  const Vec3 along = frame.transpose() * shift_;
  QStringList texts;
  for (const int axis : axes()) {
    texts << lengthText(along[axis], subject().size);
  }
  return texts;
}

QString MoveGesture::title() const {
  const QString where = lockText(lock());
  return where.isEmpty() ? QCoreApplication::translate("MoveGesture", "Moving in the view plane")
                         : QCoreApplication::translate("MoveGesture", "Moving %1").arg(where);
}

}  // namespace pbffd::ui
