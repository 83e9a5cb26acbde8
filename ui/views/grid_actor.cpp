#include "ui/views/grid_actor.h"

#include "ui/views/round_numbers.h"

#include <algorithm>
#include <cmath>

namespace pbffd::ui {
namespace {

/// How far the grid reaches from the middle, in diagonals of the mesh.
constexpr double reachInDiagonals = 3.0;
constexpr double cellsAcrossDiagonal = 10.0;
constexpr int piecesOfLine = 12;
constexpr float axisStrength = 0.65F;

/// Full within a third of the reach, gone at its end.
float strengthAt(const Vec3& point, const Vec3& middle, double reach) {
  const double distance = std::hypot(point.x() - middle.x(), point.z() - middle.z()) / reach;
  return static_cast<float>(std::clamp(1.25 * (1.0 - distance), 0.0, 1.0));
}

struct GridPlan {
  Vec3 middle;
  double reach;
};

void addLine(std::vector<Stroke>& strokes, const GridPlan& plan, const Vec3& from, const Vec3& to,
             const Rgba& color, float width) {
  const auto colorAt = [&](const Vec3& point) {
    return withAlpha(color, color[3] * strengthAt(point, plan.middle, plan.reach));
  };
  for (int i = 0; i < piecesOfLine; ++i) {
    Stroke stroke;
    stroke.from = from + (to - from) * i / piecesOfLine;
    stroke.to = from + (to - from) * (i + 1) / piecesOfLine;
    stroke.colorFrom = colorAt(stroke.from);
    stroke.colorTo = colorAt(stroke.to);
    if (stroke.colorFrom[3] <= 0.0F && stroke.colorTo[3] <= 0.0F) {
      continue;
    }
    stroke.cap = Stroke::Cap::joined;
    stroke.widthFrom = stroke.widthTo = width;
    strokes.push_back(stroke);
  }
}

}  // namespace

Grid makeGrid(const Bounds& bounds, const Vec3& origin, const GridColors& colors) {
  Grid grid;
  const double diagonal = bounds.diagonal();
  grid.spacing = roundedDown125(diagonal / cellsAcrossDiagonal);
  if (grid.spacing <= 0.0) {
    return grid;
  }
  const Vec3 center = bounds.center();
  const auto snapped = [&](double value) { return std::round(value / grid.spacing) * grid.spacing; };
  const double half = std::ceil(reachInDiagonals * diagonal / grid.spacing) * grid.spacing;
  const Vec3 middle = Vec3(snapped(center.x()), bounds.low.y(), snapped(center.z())) - origin;
  const GridPlan plan{middle, half};
  const int lines = static_cast<int>(std::round(half / grid.spacing));
  for (int i = -lines; i <= lines; ++i) {
    const double by = i * grid.spacing;
    const bool isAxisZ = std::abs(middle.x() + origin.x() + by) < 0.5 * grid.spacing;
    const bool isAxisX = std::abs(middle.z() + origin.z() + by) < 0.5 * grid.spacing;
    addLine(grid.strokes, plan, middle + Vec3(by, 0, -half), middle + Vec3(by, 0, half),
            isAxisZ ? withAlpha(colors.axisZ, axisStrength) : colors.lines, 1.0F);
    addLine(grid.strokes, plan, middle + Vec3(-half, 0, by), middle + Vec3(half, 0, by),
            isAxisX ? withAlpha(colors.axisX, axisStrength) : colors.lines, 1.0F);
  }
  return grid;
}

}  // namespace pbffd::ui
