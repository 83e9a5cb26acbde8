#pragma once

#include "core/mesh/mesh.h"
#include "ui/document/document.h"
#include "ui/document/theme.h"
#include "ui/document/view_state.h"
#include "ui/views/viewport.h"

#include <QTemporaryDir>

#include <memory>
#include <vector>

namespace pbffd::ui::test {

/// A document with one level of control points, shown in a window of 640 x 480: what tests of the view and of
/// the tools start from. Points have the identifiers 1, 2, ... and spheres as regions.
class OpenView {
 public:
  OpenView(const Mesh& mesh, const std::vector<Vec3>& points, double radius = 1.0);

  /// Whether document and window are ready for the tests.
  bool isReady() const { return isReady_; }

  Document document;
  ViewState view;
  Theme theme;
  Viewport viewport;

  /// The control point with this identifier, as shown.
  const ControlPoint& point(PointId id) const;
  /// Where it is on the view.
  QPoint placeOf(PointId id) const;
  /// Handles what is pending, the next frame included, and returns it.
  QImage frame();

 private:
  QTemporaryDir folder_;
  bool isReady_ = false;
};

/// How many pixels differ by more than `tolerance` in any channel; all when the sizes differ.
int differingPixels(const QImage& first, const QImage& second, int tolerance = 6);

}  // namespace pbffd::ui::test
