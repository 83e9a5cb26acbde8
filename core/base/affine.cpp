#include "core/base/affine.h"

#include <Eigen/LU>

namespace pbffd {

AffineMap inverted(const AffineMap& map) {
  const Mat3 linear = map.leftCols<3>();
  const Mat3 inverse = linear.inverse();
  return makeMap(inverse, -(inverse * map.col(3)));
}

}  // namespace pbffd
