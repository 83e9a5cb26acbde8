#include "core/ffd/basis.h"

#include "core/ffd/basis_slope_body.h"

#include <cmath>
#include <limits>

namespace pbffd {
namespace {

struct Here;
using Body = BlockBody<Here>;
using SlopeBody = BasisSlopeBody<Here>;

/// 1 / r^2 of axes that have one length r, 0 of others.
double inverseSquareOfSphere(const Mat3& axes) {
  // What turning a frame leaves of equal lengths.
  constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
  const Vec3 squares = axes.colwise().squaredNorm();
  const bool areEqual = squares.maxCoeff() - squares.minCoeff() <= rounding * squares.maxCoeff();
  const double inverse = 1.0 / squares[0];
  return areEqual && std::isfinite(inverse) ? inverse : 0.0;
}

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
  switch (basis.kernel) {
    case Kernel::smooth:
      return SlopeBody::smooth(uSquared);
    case Kernel::wendland:
      return SlopeBody::wendland(uSquared);
    case Kernel::gaussian:
      return SlopeBody::gaussian(basis.sigma, uSquared);
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
    : center(rest.center),
      toLocal(inverseOfOrthogonal(rest.axes)),
      inverseSquare(inverseSquareOfSphere(rest.axes)),
      halfSizes_(rest.axes.rowwise().norm()) {}

}  // namespace pbffd
