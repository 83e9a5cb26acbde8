#pragma once

#include "ui/controllers/transform_gesture.h"

namespace pbffd::ui {

/// Rotates points about the pivot: about the direction of view, about an axis, or freely like a ball.
class RotateGesture : public TransformGesture {
 public:
  enum class Manner { ring, ball };
  RotateGesture(GestureSubject subject, AxisLock lock, const QPointF& start, Manner manner = Manner::ring);

  double degrees() const { return degrees_; }
  const Vec3& axis() const { return axis_; }

  Edit edit() const override;
  bool isIdentity() const override { return degrees_ == 0.0; }
  Gizmo gizmo(const Projection& projection) const override;
  QString title() const override;

 protected:
  void follow(const Projection& projection) override;
  void lockChanged() override;
  int numberCount() const override { return 1; }
  bool takesPlanes() const override { return false; }
  QStringList amounts() const override;
  QStringList letters() const override;

 private:
  Vec3 axisOfLock(const Projection& projection) const;
  /// Adds the turn from where the cursor was followed last to where it is.
  void sweep(const Projection& projection);
  void rollBall(const Projection& projection);

  Manner manner_;
  QPointF followed_;
  double swept_ = 0.0;  ///< radians by the cursor
  double degrees_ = 0.0;
  Vec3 axis_ = Vec3::UnitZ();
};

}  // namespace pbffd::ui
