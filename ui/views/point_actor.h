#pragma once

#include "core/ffd/control_point.h"
#include "ui/views/color.h"
#include "ui/views/pass_mapper.h"

#include <vector>

#include <vtkNew.h>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace pbffd::ui {

/// How a control point is drawn: its kind by shape and colour, its state by size, rings and a slash.
struct PointSprite {
  enum Mark { selected = 1, active = 2, mirrored = 4, hovered = 8 };
  Vec3 position = Vec3::Zero();  ///< in view space
  Rgba color{1, 1, 1, 1};
  PointKind shape = PointKind::interior;
  float size = 9.0F;  ///< logical pixels across
  int marks = 0;
  bool isHollow = false;  ///< disabled: an outline with a slash through it
  float opacity = 1.0F;
  bool isOnTop = false;  ///< at full strength even behind the surface
};

/// Control points as sprites of constant size: at full strength in front of the surface, faint behind it.
class PointActor {
 public:
  explicit PointActor(vtkRenderer& renderer);
  ~PointActor();

  void setSprites(const std::vector<PointSprite>& sprites);
  struct Colors {
    Rgba halo{};
    Rgba ring{};
    Rgba active{};
  };
  void setColors(const Colors& colors);
  void setPixelRatio(double ratio);

 private:
  /// The points that share a depth rule.
  struct Pass {
    vtkNew<PassMapper> mapper;
    vtkNew<vtkActor> actor;
  };
  void addPass(Pass& pass, vtkPolyData& data, vtkRenderer& renderer, PassMapper::DepthTest test, float opacity);

  vtkNew<vtkPolyData> plain_;
  vtkNew<vtkPolyData> top_;
  Pass hidden_;
  Pass visible_;
  Pass onTop_;
};

}  // namespace pbffd::ui
