#pragma once

#include "core/ffd/control_point.h"

namespace pbffd {

enum class Kernel { smooth, wendland, gaussian };

/// The radial function that all control points of a set share (contract, section 4).
struct Basis {
  Kernel kernel = Kernel::smooth;
  double sigma = 3.0;  ///< gaussian only: standard deviations to the border of the region

  bool operator==(const Basis&) const = default;
};

/// The basis value at squared distance u^2 from the centre in region units, 1 at the centre, 0 from the
/// border on. The same bits on every processor.
double basisValue(const Basis& basis, double uSquared);

/// d value / d(u^2), with which the gradient needs no square root at the centre; 0 from the border on.
double basisSlope(const Basis& basis, double uSquared);

/// A rest frame made ready for eq. (3): u = toLocal * (v - center), the region is |u| < 1.
struct Region {
  Vec3 center;
  Mat3 toLocal;  ///< rows a/|a|^2, b/|b|^2, c/|c|^2

  explicit Region(const Frame& rest);

  /// McDonnell & Qin, eq. (3).
  Vec3 parameter(const Vec3& point) const { return toLocal * (point - center); }
  double squaredDistance(const Vec3& point) const { return parameter(point).squaredNorm(); }

  /// The half sizes of the axis-aligned box around the ellipsoid.
  Vec3 halfSizes() const { return halfSizes_; }

 private:
  Vec3 halfSizes_;
};

}  // namespace pbffd
