#pragma once

#include "core/base/types.h"

#include <functional>

namespace pbffd::ui {

/// A ray through a pixel: origin and unit direction in mesh units.
struct PickRay {
  Vec3 origin;
  Vec3 direction;
};

/// What a camera makes of a view of width x height logical pixels: world to pixels and back.
class Projection {
 public:
  /// `toWorld`: columns right, up, backward. `halfHeight`: half the height of the view, in world units at
  /// distance 1 (perspective) or anywhere (orthographic).
  struct Lens {
    Vec3 eye = Vec3::Zero();
    Mat3 toWorld = Mat3::Identity();
    double halfHeight = 1.0;
    bool orthographic = false;
    double nearDepth = 0.0;
    double farDepth = 1.0;
  };
  Projection(const Lens& lens, double width, double height);

  /// Pixels from the top left, and the depth: 0 at the near plane, 1 at the far one, linear in between;
  /// below -1 for what lies behind the eye.
  Vec3 toScreen(const Vec3& world) const;
  PickRay rayThrough(double x, double y) const;
  /// The world length of a pixel at the depth of `world`.
  double pixelSizeAt(const Vec3& world) const;
  bool isBehindEye(const Vec3& world) const;

  double width() const { return width_; }
  double height() const { return height_; }
  const Lens& lens() const { return lens_; }

 private:
  Lens lens_;
  double width_;
  double height_;
};

/// What there is to see: a sphere around the mesh and its points, and one around the ground.
struct Extent {
  Vec3 center = Vec3::Zero();
  double radius = 1.0;
  double groundRadius = 1.0;
};

/// How the scene is looked at: a turntable about the world's Y axis, that never rolls. A plain value.
struct Camera {
  Vec3 focus = Vec3::Zero();
  double yaw = 0.0;       ///< radians about Y; 0 looks along -Z, growing it moves the eye towards +X
  double pitch = 0.0;     ///< radians above the ground, -pi/2 to pi/2
  double distance = 1.0;  ///< from the eye to the focus
  double fieldOfView;     ///< radians, vertical
  bool orthographic = false;

  Camera();

  Vec3 eye() const;
  /// Columns right, up, backward.
  Mat3 axes() const;
  Vec3 right() const { return axes().col(0); }
  Vec3 up() const { return axes().col(1); }
  Vec3 forward() const { return -axes().col(2); }

  /// Turns about `pivot`, which keeps its place on the screen as long as the pitch is not at its end.
  void orbit(const Vec3& pivot, double yawBy, double pitchBy);
  void moveBy(const Vec3& shift) { focus += shift; }
  /// Brings `pivot` nearer by the factor (below 1) or farther, without moving it on the screen.
  void zoom(const Vec3& pivot, double factor);
  /// Looks from a side: see `yaw` and `pitch`; the focus and the distance stay.
  void turnTo(double newYaw, double newPitch);

  /// Calls back with every point that is to be seen.
  using EachPoint = std::function<void(const std::function<void(const Vec3&)>&)>;
  /// Puts the focus at `center` and steps back until all points fill at most the share `fill` of the view.
  void frame(const Vec3& center, const EachPoint& points, double aspect, double fill);

  /// Near and far planes follow from what is to be seen.
  Projection projection(double width, double height, const Extent& extent) const;
};

}  // namespace pbffd::ui
