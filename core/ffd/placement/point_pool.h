#pragma once

#include "core/ffd/placement/surface_parts.h"

#include <vector>

namespace pbffd {

/// Places that control points may take, and the part of the mesh that each is for.
struct PointPool {
  Points points{0, 3};
  std::vector<Index> parts;  ///< one a point

  Index size() const { return static_cast<Index>(parts.size()); }
  void append(const Vec3& point, Index part);
  /// Keeps of those at the very same position the first one, and gives back what append() kept ready. Shells
  /// that lie in each other would else bring points that nobody can tell apart.
  void dropDoubles();
  /// Gives back what append() kept ready.
  void shrink() { points.conservativeResize(size(), 3); }
};

/// On which side of the closed parts the points of a pool shall lie.
enum class Side { inside, outside };

/// Decimates a pool to `target` points, or as many as it has. Points of different parts merge only where
/// there are more parts than points. Pairs with a wall of the mesh between them are put back, and no
/// mid-point leaves its side of the surface (McDonnell & Qin, Figure 2, steps 3 and 8). What comes back is
/// checked by the winding number: where points lie on the wrong side, all such are taken out of the pool
/// first and each mid-point is asked. Parts that lie wholly on the wrong side keep their points there, and
/// their mid-points have no side to leave. Throws Cancelled.
PointPool decimatedPool(const PointPool& pool, Index target, Side side, const SurfaceParts& parts,
                        const Progress& progress);

}  // namespace pbffd
