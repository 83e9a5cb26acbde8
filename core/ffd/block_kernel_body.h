#pragma once

#include "core/ffd/block_kernels.h"

#include <cmath>
#include <limits>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

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

  /// |u|^2 of the k-th of 16 points in a region whose axes have one length.
  struct Sphere {
    double x;
    double y;
    double z;
    double inverseSquare;

    explicit Sphere(const RegionNumbers& region)
        : x(region.center[0]), y(region.center[1]), z(region.center[2]), inverseSquare(region.inverseSquare) {}
    double operator()(const double* points, std::size_t k) const {
      const double a = points[k] - x;
      const double b = points[16 + k] - y;
      const double c = points[32 + k] - z;
      return (a * a + b * b + c * c) * inverseSquare;
    }
  };

  /// The same in any region.
  struct Ellipsoid {
    double center[3];
    double m[9];

    explicit Ellipsoid(const RegionNumbers& region) {
      for (std::size_t i = 0; i < 3; ++i) {
        center[i] = region.center[i];
      }
      for (std::size_t i = 0; i < 9; ++i) {
        m[i] = region.toLocal[i];
      }
    }
    double operator()(const double* points, std::size_t k) const {
      const double x = points[k] - center[0];
      const double y = points[16 + k] - center[1];
      const double z = points[32 + k] - center[2];
      const double a = m[0] * x + m[3] * y + m[6] * z;
      const double b = m[1] * x + m[4] * y + m[7] * z;
      const double c = m[2] * x + m[5] * y + m[8] * z;
      return a * a + b * b + c * c;
    }
  };

  /// Calls visit(distance), distance(points, k) being |u|^2.
  template <class Visit>
  static void withDistance(const RegionNumbers& region, const Visit& visit) {
    if (region.inverseSquare > 0.0) {
      visit(Sphere(region));
    } else {
      visit(Ellipsoid(region));
    }
  }

  /// Calls visit(value), value(uSquared) being the basis value.
  template <class Visit>
  static void withRadial(const RadialNumbers& radial, const Visit& visit) {
    if (radial.kernel == 0) {
      visit([](double uSquared) { return smooth(uSquared); });
    } else if (radial.kernel == 1) {
      visit([](double uSquared) { return wendland(uSquared); });
    } else {
      visit([sigma = radial.sigma](double uSquared) { return gaussian(sigma, uSquared); });
    }
  }

  static void squaredDistances(const double* points, const RegionNumbers& region, double* uSquared) {
    withDistance(region, [&](const auto& distance) {
      for (std::size_t k = 0; k < 16; ++k) {
        uSquared[k] = distance(points, k);
      }
    });
  }

  static unsigned inside(const double* points, const RegionNumbers& region) {
    alignas(64) double uSquared[16];
    squaredDistances(points, region, uSquared);
    return below<16>(uSquared, 1.0);
  }

  /// Bit k: whether the k-th number is less than `border`.
  template <unsigned count>
  static unsigned below(const double* numbers, double border) {
    unsigned mask = 0;
    for (unsigned k = 0; k < count; k += lanes) {
      mask |= belowInRegister(numbers + k, border) << k;
    }
    return mask;
  }

#if defined(__AVX512F__)
  static constexpr unsigned lanes = 8;
  static unsigned belowInRegister(const double* numbers, double border) {
    return _mm512_cmp_pd_mask(_mm512_loadu_pd(numbers), _mm512_set1_pd(border), _CMP_LT_OQ);
  }
#elif defined(__AVX2__)
  static constexpr unsigned lanes = 4;
  static unsigned belowInRegister(const double* numbers, double border) {
    const __m256d less = _mm256_cmp_pd(_mm256_loadu_pd(numbers), _mm256_set1_pd(border), _CMP_LT_OQ);
    return static_cast<unsigned>(_mm256_movemask_pd(less));
  }
#else
  static constexpr unsigned lanes = 1;
  static unsigned belowInRegister(const double* numbers, double border) {
    return static_cast<unsigned>(*numbers < border);
  }
#endif

  /// The square of max(|center| - half, 0); not a number stays so, and meets nothing.
  static double squaredGap(double center, double half) {
    const double gap = std::abs(center) - half;
    return gap < 0.0 ? 0.0 : gap * gap;
  }

  /// Bounds |u|^2 over 8 boxes from below and above.
  static void bounds(const double* boxes, const Sphere& region, double* nearest, double* farthest) {
    for (std::size_t k = 0; k < 8; ++k) {
      const double x = boxes[k] - region.x;
      const double y = boxes[8 + k] - region.y;
      const double z = boxes[16 + k] - region.z;
      const double* half = boxes + 24 + k;
      nearest[k] =
          (squaredGap(x, half[0]) + squaredGap(y, half[8]) + squaredGap(z, half[16])) * region.inverseSquare;
      const double a = std::abs(x) + half[0];
      const double b = std::abs(y) + half[8];
      const double c = std::abs(z) + half[16];
      farthest[k] = (a * a + b * b + c * c) * region.inverseSquare;
    }
  }

  /// In the region's own frame: the nearest and the farthest point of the box that encloses the turned box, the
  /// farthest moved out by the rounding of its terms.
  static void bounds(const double* boxes, const Ellipsoid& region, double* nearest, double* farthest) {
    const double* m = region.m;
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
  }

  static unsigned meets(const double* boxes, const RegionNumbers& region) {
    alignas(64) double nearest[8];
    alignas(64) double farthest[8];
    withDistance(region, [&](const auto& shape) { bounds(boxes, shape, nearest, farthest); });
    return below<8>(nearest, 1.0 + 1e-9) | below<8>(farthest, 1.0 - 1e-9) << 8U;
  }

  static unsigned nearPoints(const double* points, const double* place, double limit, double* squared) {
    const Sphere sphere({place, nullptr, 1.0});
    alignas(64) double all[16];
    for (std::size_t k = 0; k < 16; ++k) {
      all[k] = sphere(points, k);
    }
    for (std::size_t k = 0; k < 16; ++k) {
      squared[k] = all[k];
    }
    return below<16>(all, limit);
  }

  static unsigned nearBoxes(const double* boxes, const double* place, double limit, double* squared) {
    constexpr double slack = 8.0 * std::numeric_limits<double>::epsilon();
    alignas(64) double all[8];
    for (std::size_t k = 0; k < 8; ++k) {
      const double* half = boxes + 24 + k;
      all[k] = squaredGap((1.0 - slack) * (boxes[k] - place[0]), (1.0 + slack) * half[0]) +
               squaredGap((1.0 - slack) * (boxes[8 + k] - place[1]), (1.0 + slack) * half[8]) +
               squaredGap((1.0 - slack) * (boxes[16 + k] - place[2]), (1.0 + slack) * half[16]);
    }
    for (std::size_t k = 0; k < 8; ++k) {
      squared[k] = all[k];
    }
    return below<8>(all, limit);
  }

  static void radial(const RadialNumbers& radial, const double* uSquared, double* values) {
    withRadial(radial, [&](const auto& value) {
      for (std::size_t k = 0; k < 16; ++k) {
        values[k] = value(uSquared[k]);
      }
    });
  }

  static constexpr std::uint64_t bits[16] = {0x1,   0x2,   0x4,   0x8,   0x10,   0x20,   0x40,   0x80,
                                             0x100, 0x200, 0x400, 0x800, 0x1000, 0x2000, 0x4000, 0x8000};

  /// Of one control point.
  template <class Distance, class Value>
  static void addMembers(const double* points, double strength, std::uint64_t members, const Distance& distance,
                         const Value& value, double* values, double* sums) {
    alignas(64) double own[16];
    for (std::size_t k = 0; k < 16; ++k) {
      const double all = strength * value(distance(points, k));
      own[k] = (members & bits[k]) != 0 ? all : 0.0;
      sums[k] += own[k];
    }
    for (std::size_t k = 0; k < 16; ++k) {
      values[k] = own[k];
    }
  }

  static void memberValues(const double* points, const PointNumbers* level, const std::int32_t* list,
                           const std::uint16_t* members, std::size_t count, double* values, double* sums) {
    if (count == 0) {
      return;
    }
    alignas(64) double total[16];
    for (std::size_t k = 0; k < 16; ++k) {
      total[k] = sums[k];
    }
    withRadial(level[*list].radial, [&](const auto& value) {
      for (std::size_t i = 0; i < count; ++i) {
        const PointNumbers& point = level[list[i]];
        withDistance(point.region, [&](const auto& distance) {
          addMembers(points, point.strength, members[i], distance, value, values + 16 * i, total);
        });
      }
    });
    for (std::size_t k = 0; k < 16; ++k) {
      sums[k] = total[k];
    }
  }

  static void inverses(const double* sums, double* inverses) {
    for (std::size_t k = 0; k < 16; ++k) {
      inverses[k] = sums[k] >= std::numeric_limits<double>::min() ? 1.0 / sums[k] : 0.0;
    }
  }

  static void weights(const double* values, std::size_t count, const double* toWeight, float* weights) {
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < 16; ++k) {
        weights[16 * i + k] = static_cast<float>(values[16 * i + k] * toWeight[k]);
      }
    }
  }

  static constexpr BlockKernels all{&squaredDistances, &inside,       &meets,    &nearPoints, &nearBoxes,
                                    &radial,           &memberValues, &inverses, &weights};
};

}  // namespace pbffd
