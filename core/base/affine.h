#pragma once

#include "core/base/types.h"

namespace pbffd {

inline AffineMap identityMap() {
  return AffineMap::Identity();
}

inline AffineMap makeMap(const Mat3& linear, const Vec3& translation) {
  AffineMap map;
  map << linear, translation;
  return map;
}

inline Vec3 applyMap(const AffineMap& map, const Vec3& point) {
  return map.leftCols<3>() * point + map.col(3);
}

/// first, then outer: composed(outer, first)(x) = outer(first(x)).
inline AffineMap composed(const AffineMap& outer, const AffineMap& first) {
  AffineMap map;
  map.leftCols<3>().noalias() = outer.leftCols<3>() * first.leftCols<3>();
  map.col(3) = applyMap(outer, first.col(3));
  return map;
}

/// The inverse of an affine map. The caller makes sure that the linear part is invertible.
AffineMap inverted(const AffineMap& map);

}  // namespace pbffd
