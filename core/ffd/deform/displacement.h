#pragma once

#include "core/ffd/weights/parameterization.h"

#include <vector>

namespace pbffd {

/// What one control point does to space, relative to rest: d(v) = (L - 1)(v - p) + (p' - p). Written about the
/// rest centre, so that it loses nothing far from the origin.
struct Displacement {
  Vec3 center;
  Mat3 linear;  ///< L - 1; all zero for a translation
  Vec3 shift;

  Displacement(const Frame& rest, const Frame& pose);
  /// The order of the operations is spelt out, so that it gives the same bits wherever it is compiled.
  Vec3 operator()(const Vec3& point) const {
    const double x = point.x() - center.x();
    const double y = point.y() - center.y();
    const double z = point.z() - center.z();
    return {linear(0, 0) * x + linear(0, 1) * y + linear(0, 2) * z + shift.x(),
            linear(1, 0) * x + linear(1, 1) * y + linear(1, 2) * z + shift.y(),
            linear(2, 0) * x + linear(2, 1) * y + linear(2, 2) * z + shift.z()};
  }
};

/// The displacements of a level's control points and the master.
struct LevelDisplacements {
  std::vector<Displacement> points;
  std::vector<char> isMoved;  ///< beside `points`: enabled, and its pose is not its rest frame
  Displacement master;
  bool isMasterMoved;

  LevelDisplacements(const Master& master, const Level& level);
  bool isAnyMoved() const;
  /// Whether anything that moved may reach the block of this list.
  bool touches(const BlockList& list) const;
};

/// Throws InvalidInput when the weights are not of this mesh and level.
void requireFitting(const Parameterization& weights, const RestMesh& mesh, const Level& level);

}  // namespace pbffd
