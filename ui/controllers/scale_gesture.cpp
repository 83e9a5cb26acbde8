#include "ui/controllers/scale_gesture.h"

#include "ui/controllers/drag_math.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pbffd::ui {
namespace {

constexpr double leastFactor = 0.01;
constexpr double snapFactor = 0.1;
constexpr double preciseSnapFactor = 0.01;
/// A drag that starts this near to the pivot has no length to compare with: so many pixels then double.
constexpr double leastReach = 12.0;
constexpr double pixelsToDouble = 100.0;

}  // namespace

double ScaleGesture::factorByCursor(const Projection& projection) const {
  const Vec3 seen = projection.toScreen(subject().pivot);
  const QPointF pivot(seen.x(), seen.y());
  const QPointF from = start() - pivot;
  const QPointF to = cursor() - pivot;
  const double reach = std::hypot(from.x(), from.y());
  if (reach < leastReach) {
    const QPointF by = cursor() - start();
    return 1.0 + (by.x() - by.y()) / pixelsToDouble;
  }
  return QPointF::dotProduct(to, from) / (reach * reach);
}

void ScaleGesture::follow(const Projection& projection) {
  if (const auto number = typed(0)) {
    factor_ = *number;
  } else {
    factor_ = factorByCursor(projection);
    if (snaps()) {
      factor_ = snapped(factor_, isPrecise() ? preciseSnapFactor : snapFactor);
    }
  }
  factor_ = std::max(factor_, leastFactor);
}

Edit ScaleGesture::edit() const {
  Transform transform;
  transform.where = {subject().level, subject().points};
  transform.spread.master = subject().isWholeLevel && !subject().eachItsOwn;
  transform.eachItsOwn = subject().eachItsOwn;
  if (!transform.eachItsOwn) {
    transform.pivot = subject().pivot;
  }
  transform.basis = lockAxes();
  for (int axis = 0; axis < 3; ++axis) {
    const bool isScaled =
        lock().kind == AxisLock::Kind::free || (lock().kind == AxisLock::Kind::axis) == (axis == lock().axis);
    transform.scale[axis] = isScaled ? factor_ : 1.0;
  }
  return transform;
}

Gizmo ScaleGesture::gizmo(const Projection&) const {
  Gizmo gizmo;
  gizmo.kind = GizmoKind::scale;
  gizmo.center = subject().pivot;
  gizmo.axes = lockAxes();
  gizmo.dragged = lock().part();
  return gizmo;
}

QStringList ScaleGesture::letters() const {
  return lock().kind == AxisLock::Kind::axis ? QStringList{axisLetter(lock().axis)} : QStringList{};
}

QStringList ScaleGesture::amounts() const {
  return {QStringLiteral("%1 %").arg(100.0 * factor_, 0, 'f', isPrecise() ? 1 : 0)};
}

QString ScaleGesture::title() const {
  const QString where = lockText(lock());
  return where.isEmpty() ? QCoreApplication::translate("ScaleGesture", "Scaling")
                         : QCoreApplication::translate("ScaleGesture", "Scaling %1").arg(where);
}

}  // namespace pbffd::ui
