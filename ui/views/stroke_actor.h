#pragma once

#include "core/base/types.h"
#include "ui/views/color.h"
#include "ui/views/pass_mapper.h"

#include <vector>

#include <vtkNew.h>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace pbffd::ui {

/// A straight line with smooth borders whose width is given in logical pixels at each end: lines, arrow
/// heads (one end of width 0), discs (no length, round).
struct Stroke {
  enum class Cap {
    joined,  ///< one of a polyline: its ends are left to its neighbours
    round,
    flat
  };
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
  float widthFrom = 1.0F;
  float widthTo = 1.0F;
  Rgba colorFrom{1, 1, 1, 1};
  Rgba colorTo{1, 1, 1, 1};
  Cap cap = Cap::flat;
  float dash = 0.0F;  ///< pixels drawn, then `gap` pixels not; gap 0: solid
  float gap = 0.0F;
};

/// A polyline through the points, closed or not, in one colour and width.
void appendPolyline(std::vector<Stroke>& strokes, const std::vector<Vec3>& points, bool closed,
                    const Stroke& like);

/// Draws strokes, in their order.
class StrokeActor {
 public:
  explicit StrokeActor(vtkRenderer& renderer);
  ~StrokeActor();

  /// In view space (relative to the scene's origin).
  void setStrokes(const std::vector<Stroke>& strokes);
  PassMapper& mapper() { return *mapper_; }
  void setPixelRatio(double ratio);
  void setOpacity(double opacity);
  void setVisible(bool visible);

 private:
  vtkNew<PassMapper> mapper_;
  vtkNew<vtkActor> actor_;
  vtkNew<vtkPolyData> data_;
};

/// A flat triangle with one colour.
struct Fill {
  Vec3 corners[3];
  Rgba color{1, 1, 1, 1};
};

/// Draws flat triangles, in their order.
class FillActor {
 public:
  explicit FillActor(vtkRenderer& renderer);
  ~FillActor();

  void setFills(const std::vector<Fill>& fills);
  PassMapper& mapper() { return *mapper_; }
  void setVisible(bool visible);

 private:
  vtkNew<PassMapper> mapper_;
  vtkNew<vtkActor> actor_;
  vtkNew<vtkPolyData> data_;
};

}  // namespace pbffd::ui
