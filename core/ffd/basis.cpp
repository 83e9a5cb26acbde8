#include "core/ffd/basis.h"

#include <array>
#include <cmath>

namespace pbffd {
namespace {

/// e^x for x <= 0, within 2 units in the last place: x = k ln 2 + r, the Taylor series of e^r to the 13th
/// power (|r| <= ln 2 / 2 leaves 4e-18), scaled by 2^k. Multiplications and additions alone.
double portableExp(double x) {
  if (x < -745.2) {
    return 0.0;
  }
  constexpr double log2OfE = 1.4426950408889634;
  // ln 2 in two parts; the first has trailing zeros, so that k times it is exact.
  constexpr double ln2High = 6.93147180369123816490e-01;
  constexpr double ln2Low = 1.90821492927058770002e-10;
  const double k = std::floor(x * log2OfE + 0.5);
  const double r = (x - k * ln2High) - k * ln2Low;
  constexpr std::array<double, 12> inverseFactorials = {
      1.0 / 6227020800.0, 1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0,
      1.0 / 5040.0,       1.0 / 720.0,       1.0 / 120.0,      1.0 / 24.0,      1.0 / 6.0,      1.0 / 2.0};
  double series = 0.0;
  for (const double coefficient : inverseFactorials) {
    series = series * r + coefficient;
  }
  return std::ldexp(1.0 + (r + r * r * series), static_cast<int>(k));
}

double smooth(double uSquared) {
  const double t = 1.0 - uSquared;
  return uSquared < 1.0 ? t * t * t : 0.0;
}

double wendland(double uSquared) {
  const double u = std::sqrt(uSquared);
  const double t = 1.0 - u;
  return uSquared < 1.0 ? t * t * (t * t) * (4.0 * u + 1.0) : 0.0;
}

double gaussian(double sigma, double uSquared) {
  return uSquared < 1.0 ? portableExp(-0.5 * sigma * sigma * uSquared) : 0.0;
}

template <class Function>
Lanes forEach(const Lanes& uSquared, const Function& function) {
  Lanes values;
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = function(uSquared[k]);
  }
  return values;
}

}  // namespace

double basisValue(const Basis& basis, double uSquared) {
  switch (basis.kernel) {
    case Kernel::smooth:
      return smooth(uSquared);
    case Kernel::wendland:
      return wendland(uSquared);
    case Kernel::gaussian:
      return gaussian(basis.sigma, uSquared);
  }
  return 0.0;
}

Lanes basisValues(const Basis& basis, const Lanes& uSquared) {
  switch (basis.kernel) {
    case Kernel::smooth:
      return forEach(uSquared, smooth);
    case Kernel::wendland:
      return forEach(uSquared, wendland);
    case Kernel::gaussian:
      return forEach(uSquared, [&](double square) { return gaussian(basis.sigma, square); });
  }
  return {};
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
      return -0.5 * basis.sigma * basis.sigma * gaussian(basis.sigma, uSquared);
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
