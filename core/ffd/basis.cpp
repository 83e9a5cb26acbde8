#include "core/ffd/basis.h"

#include "core/ffd/block_kernel_body.h"

#include <cmath>

namespace pbffd {
namespace {

struct Here;
using Body = BlockBody<Here>;

}  // namespace

double basisValue(const Basis& basis, double uSquared) {
  switch (basis.kernel) {
    case Kernel::smooth:
      return Body::smooth(uSquared);
    case Kernel::wendland:
      return Body::wendland(uSquared);
    case Kernel::gaussian:
      return Body::gaussian(basis.sigma, uSquared);
  }
  return 0.0;
}

Lanes basisValues(const Basis& basis, const Lanes& uSquared) {
  Lanes values;
  blockKernels().radial(numbersOf(basis), uSquared.data(), values.data());
  return values;
}

double basisSlope(const Basis& basis, double uSquared) {
  if (!(uSquared < 1.0)) {
    return 0.0;
  }
  switch (basis.kernel) {
    case Kernel::smooth: {
      const double t = 1.0 - uSquared;
      return -3.0 * t * t;
    }
    case Kernel::wendland: {
      // d/du is -20 u (1 - u)^3; half of it over u.
      const double t = 1.0 - std::sqrt(uSquared);
      return -10.0 * t * t * t;
    }
    case Kernel::gaussian:
      return -0.5 * basis.sigma * basis.sigma * Body::gaussian(basis.sigma, uSquared);
  }
  return 0.0;
}

Mat3 inverseOfOrthogonal(const Mat3& axes) {
  Mat3 inverse;
  for (int k = 0; k < 3; ++k) {
    inverse.row(k) = axes.col(k).transpose() / axes.col(k).squaredNorm();
  }
  return inverse;
}

Region::Region(const Frame& rest)
    : center(rest.center), toLocal(inverseOfOrthogonal(rest.axes)), halfSizes_(rest.axes.rowwise().norm()) {}

}  // namespace pbffd
