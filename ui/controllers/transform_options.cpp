#include "ui/controllers/transform_options.h"

namespace pbffd::ui {

void TransformOptions::setAxes(AxesChoice axes) {
  if (axes_ != axes) {
    axes_ = axes;
    Q_EMIT changed();
  }
}

void TransformOptions::setPivot(PivotChoice pivot) {
  if (pivot_ != pivot) {
    pivot_ = pivot;
    Q_EMIT changed();
  }
}

void TransformOptions::setSnaps(bool snaps) {
  if (snaps_ != snaps) {
    snaps_ = snaps;
    Q_EMIT changed();
  }
}

}  // namespace pbffd::ui
