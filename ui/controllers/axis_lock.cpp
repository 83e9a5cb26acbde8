#include "ui/controllers/axis_lock.h"

#include <array>

namespace pbffd::ui {

AxisLock AxisLock::afterKey(int pressedAxis, bool toPlane) const {
  const Kind wanted = toPlane ? Kind::plane : Kind::axis;
  if (kind != wanted || axis != pressedAxis || space == Space::gizmo) {
    return {wanted, pressedAxis, Space::global};
  }
  return space == Space::local ? AxisLock{} : AxisLock{wanted, pressedAxis, Space::local};
}

GizmoPart AxisLock::part() const {
  constexpr std::array<GizmoPart, 3> axes{GizmoPart::axisX, GizmoPart::axisY, GizmoPart::axisZ};
  constexpr std::array<GizmoPart, 3> planes{GizmoPart::planeX, GizmoPart::planeY, GizmoPart::planeZ};
  switch (kind) {
    case Kind::axis:
      return axes[axis];
    case Kind::plane:
      return planes[axis];
    case Kind::free:
      break;
  }
  return GizmoPart::center;
}

AxisLock lockOf(GizmoPart part) {
  const auto axis = axisOf(part);
  if (!axis) {
    return {};
  }
  return {isPlane(part) ? AxisLock::Kind::plane : AxisLock::Kind::axis, *axis, AxisLock::Space::gizmo};
}

}  // namespace pbffd::ui
