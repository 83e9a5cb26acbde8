#pragma once

#include "ui/controllers/transform_gesture.h"

namespace pbffd::ui {

/// Moves points: in the view plane through the pivot, along an axis, or in a plane.
class MoveGesture : public TransformGesture {
 public:
  using TransformGesture::TransformGesture;

  const Vec3& shift() const { return shift_; }

  Edit edit() const override;
  bool isIdentity() const override { return shift_.isZero(0.0); }
  Gizmo gizmo(const Projection& projection) const override;
  QString title() const override;

 protected:
  void follow(const Projection& projection) override;
  int numberCount() const override { return lock().freedoms(); }
  bool takesPlanes() const override { return true; }
  QStringList amounts() const override;
  QStringList letters() const override;

 private:
  /// The axes that numbers are given along, in order.
  std::vector<int> axes() const;
  /// How far along the locked axis a place on the screen is; none for an axis that points at the eye.
  std::optional<double> alongAxis(const Projection& projection, const QPointF& at) const;
  /// By the cursor alone, in world axes.
  Vec3 shiftByCursor(const Projection& projection) const;
  void snapAlong(const Mat3& frame, double step);

  Vec3 shift_ = Vec3::Zero();
};

}  // namespace pbffd::ui
