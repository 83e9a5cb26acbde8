#pragma once

#include "core/base/progress.h"
#include "core/base/types.h"

#include <span>
#include <vector>

namespace pbffd {

/// The cells of a Delaunay triangulation: four points, or more where they lie on one sphere.
struct DelaunayCells {
  std::vector<Index> start{0};  ///< C + 1 entries
  std::vector<Index> points;    ///< rows, those of cell c from start[c] on, ascending

  Index size() const { return static_cast<Index>(start.size()) - 1; }
  std::span<const Index> operator[](Index cell) const {
    return {points.data() + start[cell], points.data() + start[cell + 1]};
  }
};

/// By Qhull's reentrant library, which only this file's source knows. The points must be finite, distinct,
/// not coplanar, and within a few units of the origin. Reports the share of points done as "Placing points:
/// cells". Throws SolverError where Qhull gives up; Cancelled.
DelaunayCells delaunayCells(const Points& points, const Progress& progress);

}  // namespace pbffd
