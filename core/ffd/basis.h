#pragma once

#include "core/ffd/block_kernels.h"
#include "core/ffd/control_point.h"

#include <array>

namespace pbffd {

enum class Kernel { smooth, wendland, gaussian };

/// The radial function that all control points of a set share (contract, section 4).
struct Basis {
  Kernel kernel = Kernel::smooth;
  double sigma = 3.0;  ///< gaussian only: standard deviations to the border of the region

  bool operator==(const Basis&) const = default;
};

inline RadialNumbers numbersOf(const Basis& basis) {
  return {static_cast<int>(basis.kernel), basis.sigma};
}

/// The basis value at squared distance u^2 from the centre in region units, 1 at the centre, 0 from the
/// border on (McDonnell & Qin, eq. (1)). The same bits on every processor: the gaussian does not use the
/// system's exp, whose result depends on the instructions at hand.
double basisValue(const Basis& basis, double uSquared);

/// Sixteen numbers, one a vertex of a block.
struct alignas(64) Lanes : std::array<double, 16> {};

/// basisValue() of each, the same bits.
Lanes basisValues(const Basis& basis, const Lanes& uSquared);

/// d value / d(u^2), with which the gradient needs no square root at the centre; 0 from the border on.
double basisSlope(const Basis& basis, double uSquared);

/// A rest frame made ready for eq. (3): u = toLocal * (v - center), the region is |u| < 1.
struct Region {
  Vec3 center;
  Mat3 toLocal;  ///< rows a/|a|^2, b/|b|^2, c/|c|^2
  /// 1 / r^2 where the axes have one length r but for rounding, so that the region is a sphere; 0 elsewhere.
  double inverseSquare;

  explicit Region(const Frame& rest);

  /// McDonnell & Qin, eq. (3). The order of the operations is spelt out, so that it gives the same bits
  /// wherever it is compiled.
  Vec3 parameter(const Vec3& point) const {
    const double x = point.x() - center.x();
    const double y = point.y() - center.y();
    const double z = point.z() - center.z();
    return {toLocal(0, 0) * x + toLocal(0, 1) * y + toLocal(0, 2) * z,
            toLocal(1, 0) * x + toLocal(1, 1) * y + toLocal(1, 2) * z,
            toLocal(2, 0) * x + toLocal(2, 1) * y + toLocal(2, 2) * z};
  }
  /// |u|^2; in a sphere as |v - center|^2 / r^2.
  double squaredDistance(const Vec3& point) const {
    if (inverseSquare > 0.0) {
      const double x = point.x() - center.x();
      const double y = point.y() - center.y();
      const double z = point.z() - center.z();
      return (x * x + y * y + z * z) * inverseSquare;
    }
    const Vec3 u = parameter(point);
    return u.x() * u.x() + u.y() * u.y() + u.z() * u.z();
  }

  RegionNumbers numbers() const { return {center.data(), toLocal.data(), inverseSquare}; }

  /// The half sizes of the axis-aligned box around the ellipsoid.
  Vec3 halfSizes() const { return halfSizes_; }

 private:
  Vec3 halfSizes_;
};

/// The inverse of orthogonal axes (columns a, b, c): rows a/|a|^2, b/|b|^2, c/|c|^2.
Mat3 inverseOfOrthogonal(const Mat3& axes);

}  // namespace pbffd
