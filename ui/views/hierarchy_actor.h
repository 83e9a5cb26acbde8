#pragma once

#include "core/base/types.h"
#include "ui/views/stroke_actor.h"

#include <vector>

namespace pbffd::ui {

/// Thin lines from merged control points to the points that they stand for, each thinner towards the finer
/// one, with a small knot, larger for the coarser of two, where no glyph of a point is drawn. What the surface
/// hides is fainter, and the more lines there are, the fainter all of them, so that the shape stays in sight.
class HierarchyActor {
 public:
  explicit HierarchyActor(vtkRenderer& renderer);

  static constexpr std::size_t mostInFull = 60;  ///< with more of them each is fainter
  static constexpr double leastShare = 0.45;
  static constexpr double hiddenShare = 0.4;  ///< of what lies behind the surface

  struct Link {
    Vec3 parent = Vec3::Zero();
    Vec3 child = Vec3::Zero();
    bool hasParentGlyph = false;
    bool hasChildGlyph = false;
  };
  struct Colors {
    Rgba line{};
    Rgba halo{};  ///< parts the lines from what is behind them
  };
  void setColors(const Colors& colors);
  void setPixelRatio(double ratio);

  /// In view space.
  void setLinks(std::vector<Link> links);

  /// What is drawn, halos first.
  std::vector<Stroke> strokes() const;

 private:
  void draw();

  StrokeActor hidden_;
  StrokeActor visible_;
  std::vector<Link> links_;
  Colors colors_;
};

}  // namespace pbffd::ui
