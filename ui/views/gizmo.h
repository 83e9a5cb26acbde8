#pragma once

#include "core/base/types.h"
#include "ui/views/camera.h"

#include <array>
#include <optional>
#include <vector>

namespace pbffd::ui {

enum class GizmoKind { none, move, rotate, scale };

/// What of a gizmo can be dragged. A plane is named by its normal.
enum class GizmoPart {
  none,
  axisX,
  axisY,
  axisZ,
  planeX,
  planeY,
  planeZ,
  center,  ///< move: the view plane; scale: uniform
  view,    ///< rotate: the outer ring, about the direction of view
  ball     ///< rotate: freely
};

/// The axis that a part acts along or about (0, 1, 2), or whose plane it is; none for the others.
std::optional<int> axisOf(GizmoPart part);
bool isPlane(GizmoPart part);

/// What a gizmo shows: where it is, how it is turned, which part the cursor is over and which is dragged.
struct Gizmo {
  GizmoKind kind = GizmoKind::none;
  Vec3 center = Vec3::Zero();
  Mat3 axes = Mat3::Identity();  ///< columns: unit directions
  GizmoPart hovered = GizmoPart::none;
  GizmoPart dragged = GizmoPart::none;  ///< the other parts hide

  /// Rotating: the swept angle, as a pie in the plane of `normal` from the direction `start`.
  struct Pie {
    Vec3 normal = Vec3::UnitZ();
    Vec3 start = Vec3::UnitX();
    double radians = 0.0;
  };
  std::optional<Pie> pie;
};

/// Sizes in logical pixels.
struct GizmoSizes {
  static constexpr double length = 110.0;
  static constexpr double ring = 90.0;
  static constexpr double hitWidth = 12.0;
  static constexpr double freeCenter = 12.0;
  static constexpr double head = 13.0;
  static constexpr double planeFrom = 22.0;
  static constexpr double planeTo = 42.0;
  /// An axis that is shorter than this on the screen points at the eye and can neither be seen nor dragged.
  static constexpr double leastAxis = 14.0;
};

/// Where the parts are, for drawing and for the cursor.
class GizmoShape {
 public:
  GizmoShape(const Gizmo& gizmo, const Projection& projection);

  /// The world length of a pixel at the centre.
  double pixel() const { return pixel_; }
  Vec3 axisEnd(int axis) const;
  /// Whether the axis is long enough on the screen.
  bool isAxisSeen(int axis) const;
  /// Whether the plane square is not seen from its edge.
  bool isPlaneSeen(int normal) const;
  std::array<Vec3, 4> planeCorners(int normal) const;
  /// The ring about an axis, or the outer ring about the direction of view (axis 3).
  std::vector<Vec3> ring(int axis) const;
  /// Whether a point of a ring is on the half that faces the eye.
  bool isInFront(const Vec3& point) const;

  GizmoPart partAt(double x, double y) const;

 private:
  GizmoPart partOfRings(double x, double y) const;
  GizmoPart partOfAxes(double x, double y) const;

  Gizmo gizmo_;
  const Projection& projection_;
  double pixel_;
  Vec3 towardsEye_;
};

}  // namespace pbffd::ui
