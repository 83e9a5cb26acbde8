#pragma once

#include "ui/views/gizmo.h"
#include "ui/views/stroke_actor.h"

#include <array>
#include <vector>

namespace pbffd::ui {

/// Draws a gizmo over everything else, at a constant size on the screen.
class GizmoActor {
 public:
  explicit GizmoActor(vtkRenderer& renderer);

  struct Colors {
    std::array<Rgba, 3> axes{};
    Rgba center{1, 1, 1, 1};
    Rgba halo{};
    Rgba highlight{1, 1, 1, 1};  ///< mixed into the part under the cursor
    float highlightShare = 0.45F;
  };
  void setColors(const Colors& colors) { colors_ = colors; }
  void setPixelRatio(double ratio) { strokes_.setPixelRatio(ratio); }

  /// In view space.
  void draw(const Gizmo& gizmo, const Projection& projection);

 private:
  struct Parts {
    std::vector<Stroke> strokes;
    std::vector<Fill> fills;
  };
  struct Look {
    Rgba color{};
    float width = 3.0F;
  };
  Look lookOf(const Gizmo& gizmo, GizmoPart part) const;
  void addAxis(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape, int axis) const;
  void addPlane(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape, int normal) const;
  void addRing(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape, int axis) const;
  void addCenter(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape) const;
  void addGuides(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape) const;
  void addPie(Parts& parts, const Gizmo& gizmo, const GizmoShape& shape) const;

  FillActor fills_;
  StrokeActor strokes_;
  Colors colors_;
};

}  // namespace pbffd::ui
