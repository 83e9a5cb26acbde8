#pragma once

#include "core/ffd/block_kernels.h"

#include <cmath>

namespace pbffd {

/// The loops that all variants share, left to the compiler to turn into each one's instructions. `Here` is a
/// type of the including file's own, so that no two files share an instance.
template <class Here>
struct BlockBody {
  static double smooth(double uSquared) {
    const double t = 1.0 - uSquared;
    return uSquared < 1.0 ? t * t * t : 0.0;
  }

  static double wendland(double uSquared) {
    const double u = std::sqrt(uSquared);
    const double t = 1.0 - u;
    return uSquared < 1.0 ? t * t * (t * t) * (4.0 * u + 1.0) : 0.0;
  }

  static double gaussian(double sigma, double uSquared) {
    return uSquared < 1.0 ? portableExp(-0.5 * sigma * sigma * uSquared) : 0.0;
  }

  /// e^x for x <= 0, within 1e-15 of the value and 0 below e^-708: x = k ln 2 + r, the Taylor series of e^r to
  /// the 13th power (|r| <= ln 2 / 2 leaves 4e-18), scaled by 2^k. Multiplications and additions alone.
  static double portableExp(double x) {
    constexpr double log2OfE = 1.4426950408889634;
    // ln 2 in two parts; the first has trailing zeros, so that k times it is exact.
    constexpr double ln2High = 6.93147180369123816490e-01;
    constexpr double ln2Low = 1.90821492927058770002e-10;
    // Added to a small number, it leaves the nearest integer in the last bits.
    constexpr double rounder = 6755399441055744.0;
    const double shifted = x * log2OfE + rounder;
    const double k = shifted - rounder;
    const double r = (x - k * ln2High) - k * ln2Low;
    double series = 1.0 / 6227020800.0;
    series = series * r + 1.0 / 479001600.0;
    series = series * r + 1.0 / 39916800.0;
    series = series * r + 1.0 / 3628800.0;
    series = series * r + 1.0 / 362880.0;
    series = series * r + 1.0 / 40320.0;
    series = series * r + 1.0 / 5040.0;
    series = series * r + 1.0 / 720.0;
    series = series * r + 1.0 / 120.0;
    series = series * r + 1.0 / 24.0;
    series = series * r + 1.0 / 6.0;
    series = series * r + 0.5;
    const std::uint64_t bits = __builtin_bit_cast(std::uint64_t, shifted);
    const double power = __builtin_bit_cast(double, (bits + 1023U) << 52U);
    return x < -708.0 ? 0.0 : power * (1.0 + (r + r * r * series));
  }

  static double squaredDistance(const double* points, const RegionNumbers& region, std::size_t k) {
    const double* m = region.toLocal;
    const double x = points[k] - region.center[0];
    const double y = points[16 + k] - region.center[1];
    const double z = points[32 + k] - region.center[2];
    const double a = m[0] * x + m[3] * y + m[6] * z;
    const double b = m[1] * x + m[4] * y + m[7] * z;
    const double c = m[2] * x + m[5] * y + m[8] * z;
    return a * a + b * b + c * c;
  }

  static void squaredDistances(const double* points, const RegionNumbers& region, double* uSquared) {
    for (std::size_t k = 0; k < 16; ++k) {
      uSquared[k] = squaredDistance(points, region, k);
    }
  }

  static unsigned inside(const double* points, const RegionNumbers& region) {
    alignas(64) double uSquared[16];
    squaredDistances(points, region, uSquared);
    unsigned mask = 0;
    for (unsigned k = 0; k < 16; ++k) {
      mask |= static_cast<unsigned>(uSquared[k] < 1.0) << k;
    }
    return mask;
  }

  /// The square of max(|center| - half, 0); not a number stays so, and meets nothing.
  static double squaredGap(double center, double half) {
    const double gap = std::abs(center) - half;
    return gap < 0.0 ? 0.0 : gap * gap;
  }

  /// In the region's own frame: the nearest and the farthest point of the box that encloses the turned box, the
  /// farthest moved out by the rounding of its terms.
  static unsigned meets(const double* boxes, const RegionNumbers& region) {
    alignas(64) double nearest[8];
    alignas(64) double farthest[8];
    const double* m = region.toLocal;
    for (std::size_t k = 0; k < 8; ++k) {
      const double x = boxes[k] - region.center[0];
      const double y = boxes[8 + k] - region.center[1];
      const double z = boxes[16 + k] - region.center[2];
      const double* half = boxes + 24 + k;
      double near = 0.0;
      double far = 0.0;
      for (int row = 0; row < 3; ++row) {
        const double a = m[row] * x;
        const double b = m[row + 3] * y;
        const double c = m[row + 6] * z;
        const double reach =
            std::abs(m[row]) * half[0] + std::abs(m[row + 3]) * half[8] + std::abs(m[row + 6]) * half[16];
        near += squaredGap(a + b + c, reach);
        const double end = std::abs(a + b + c) + reach + 1e-12 * (std::abs(a) + std::abs(b) + std::abs(c));
        far += end * end;
      }
      nearest[k] = near;
      farthest[k] = far;
    }
    unsigned mask = 0;
    for (unsigned k = 0; k < 8; ++k) {
      mask |= static_cast<unsigned>(nearest[k] < 1.0 + 1e-9) << k;
      mask |= static_cast<unsigned>(farthest[k] < 1.0 - 1e-9) << (8 + k);
    }
    return mask;
  }

  static void radial(const RadialNumbers& radial, const double* uSquared, double* values) {
    if (radial.kernel == 0) {
      for (std::size_t k = 0; k < 16; ++k) {
        values[k] = smooth(uSquared[k]);
      }
    } else if (radial.kernel == 1) {
      for (std::size_t k = 0; k < 16; ++k) {
        values[k] = wendland(uSquared[k]);
      }
    } else {
      const double sigma = radial.sigma;
      for (std::size_t k = 0; k < 16; ++k) {
        values[k] = gaussian(sigma, uSquared[k]);
      }
    }
  }

  static void memberValues(const double* points, const InfluenceNumbers& influence, double* values,
                           double* sums) {
    alignas(64) double uSquared[16];
    squaredDistances(points, influence.region, uSquared);
    radial(influence.radial, uSquared, values);
    for (unsigned k = 0; k < 16; ++k) {
      const double value = (influence.members >> k & 1U) != 0 ? influence.strength * values[k] : 0.0;
      values[k] = value;
      sums[k] += value;
    }
  }

  static void weights(const double* values, const double* toWeight, float* weights) {
    for (std::size_t k = 0; k < 16; ++k) {
      weights[k] = static_cast<float>(values[k] * toWeight[k]);
    }
  }

  static constexpr BlockKernels all{&squaredDistances, &inside, &meets, &radial, &memberValues, &weights};
};

}  // namespace pbffd
