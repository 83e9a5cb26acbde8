#pragma once

#include "ui/views/gizmo.h"

namespace pbffd::ui {

/// What a gesture is held to: nothing, an axis, or the plane that an axis is normal to. A value.
struct AxisLock {
  enum class Kind { free, axis, plane };
  Kind kind = Kind::free;
  int axis = 0;
  /// Whose axes: those that the gizmo shows, the world's, or those of the active point.
  enum class Space { gizmo, global, local };
  Space space = Space::gizmo;

  /// X, Y or Z pressed: locks to the global axis, again: to the local one, again: free.
  AxisLock afterKey(int pressedAxis, bool toPlane) const;
  /// How many numbers say what the gesture does.
  int freedoms() const { return kind == Kind::axis ? 1 : kind == Kind::plane ? 2 : 3; }
  /// The part of the gizmo that does the same.
  GizmoPart part() const;
  bool operator==(const AxisLock&) const = default;
};

/// The lock that dragging a part of the gizmo means.
AxisLock lockOf(GizmoPart part);

}  // namespace pbffd::ui
