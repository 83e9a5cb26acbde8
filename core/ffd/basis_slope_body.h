#pragma once

#include "core/ffd/block_kernel_body.h"

#include <cmath>

namespace pbffd {

/// The slopes of the basis values over |u|^2, with `Here` as in BlockBody.
template <class Here>
struct BasisSlopeBody {
  static double smooth(double uSquared) {
    const double t = 1.0 - uSquared;
    return uSquared < 1.0 ? -3.0 * t * t : 0.0;
  }

  /// d/du is -20 u (1 - u)^3; half of it over u.
  static double wendland(double uSquared) {
    const double t = 1.0 - std::sqrt(uSquared);
    return uSquared < 1.0 ? -10.0 * t * t * t : 0.0;
  }

  static double gaussian(double sigma, double uSquared) {
    return -0.5 * sigma * sigma * BlockBody<Here>::gaussian(sigma, uSquared);
  }
};

}  // namespace pbffd
