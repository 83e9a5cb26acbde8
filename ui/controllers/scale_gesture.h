#pragma once

#include "ui/controllers/transform_gesture.h"

namespace pbffd::ui {

/// Scales points about the pivot: in all directions, along an axis, or in a plane. Never to nothing and
/// never through it: it stops at 1 %.
class ScaleGesture : public TransformGesture {
 public:
  using TransformGesture::TransformGesture;

  double factor() const { return factor_; }

  Edit edit() const override;
  bool isIdentity() const override { return factor_ == 1.0; }
  Gizmo gizmo(const Projection& projection) const override;
  QString title() const override;

 protected:
  void follow(const Projection& projection) override;
  int numberCount() const override { return 1; }
  bool takesPlanes() const override { return true; }
  QStringList amounts() const override;
  QStringList letters() const override;

 private:
  double factorByCursor(const Projection& projection) const;

  double factor_ = 1.0;
};

}  // namespace pbffd::ui
