#pragma once

#include "core/base/types.h"
#include "ui/views/camera.h"

#include <QPointF>
#include <QRectF>

#include <optional>
#include <vector>

namespace pbffd::ui {

struct PickablePoint {
  PointId id = 0;
  Vec3 position = Vec3::Zero();
};

/// The points within `radius` pixels of `at`, what a click takes first to last: those that the cursor is
/// well inside by their depth, nearest first, then the others by their distance on the screen.
std::vector<PointId> pickPoints(const std::vector<PickablePoint>& points, const Projection& projection,
                                const QPointF& at, double radius);

/// The points within a box on the screen, in their order, hidden ones too.
std::vector<PointId> pickPointsIn(const std::vector<PickablePoint>& points, const Projection& projection,
                                  const QRectF& box);

/// Where a ray meets a surface first.
struct SurfacePick {
  Index triangle = 0;
  double distance = 0.0;  ///< along the ray
};
/// `positions` 3 a vertex, `triangles` 3 a triangle, the ray in the same space. Triangles are met from
/// both sides; of several at the same distance the lowest index counts. Runs in parallel.
std::optional<SurfacePick> pickSurface(const std::vector<float>& positions, const std::vector<Index>& triangles,
                                       const PickRay& ray);

}  // namespace pbffd::ui
