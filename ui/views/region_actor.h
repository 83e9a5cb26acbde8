#pragma once

#include "core/ffd/control_point.h"
#include "ui/views/camera.h"
#include "ui/views/stroke_actor.h"

#include <vector>

namespace pbffd::ui {

/// The regions of influence of posed control points: a faint fill, three rings and the border as the camera
/// sees it. The more regions, the fainter each, so that the mesh stays in sight; of many only the rings are
/// drawn.
class RegionActor {
 public:
  explicit RegionActor(vtkRenderer& renderer);

  static constexpr std::size_t mostFilled = 60;
  static constexpr std::size_t mostInFull = 6;  ///< with more of them each is fainter
  static constexpr double leastShareOfLines = 0.25;

  struct Colors {
    Rgba fill{};
    Rgba rings{};
    Rgba outline{};
  };
  void setColors(const Colors& colors);
  void setPixelRatio(double ratio);

  /// In view space.
  void setRegions(std::vector<Frame> regions);
  /// The borders depend on where the camera is.
  void setLens(const Projection::Lens& lens);

 private:
  double shareOfFills() const;
  double shareOfLines() const;
  void drawRings();
  void drawOutlines(const Projection::Lens& lens);

  FillActor fills_;
  StrokeActor rings_;
  StrokeActor outlines_;
  std::vector<Frame> regions_;
  Colors colors_;
  bool hasOutlines_ = false;
};

}  // namespace pbffd::ui
