#pragma once

#include "core/ffd/basis_slope_body.h"
#include "core/ffd/deform/space_kernels.h"

namespace pbffd {

/// The loops that all variants share, left to the compiler to turn into each one's instructions; `Here` as in
/// BlockBody.
template <class Here>
struct SpaceBody {
  using Block = BlockBody<Here>;
  using Slopes = BasisSlopeBody<Here>;

  /// The row of a matrix, column after column, times a vector: the order of Displacement and Region.
  static double row(const double* m, double x, double y, double z) { return m[0] * x + m[3] * y + m[6] * z; }

  static void addDisplacement(const SpaceTerm& term, double* __restrict__ sums) {
    const Numbers d(term.displacement);
    const double* const points = term.points;
    for (int k = 0; k < 16; ++k) {
      const double x = points[k] - d.center[0];
      const double y = points[16 + k] - d.center[1];
      const double z = points[32 + k] - d.center[2];
      const double weight = term.values[k] * term.toWeight[k];
      sums[k] += weight * (row(d.linear, x, y, z) + d.shift[0]);
      sums[16 + k] += weight * (row(d.linear + 1, x, y, z) + d.shift[1]);
      sums[32 + k] += weight * (row(d.linear + 2, x, y, z) + d.shift[2]);
    }
  }

  static void addGradient(const SpaceTerm& term, const InfluenceNumbers& influence,
                          GradientSums& __restrict__ sums) {
    alignas(64) double slopes[48];
    slopesOf(term.points, influence, slopes);
    const Numbers d(term.displacement);
    const double* const points = term.points;
    for (int k = 0; k < 16; ++k) {
      const double x = points[k] - d.center[0];
      const double y = points[16 + k] - d.center[1];
      const double z = points[32 + k] - d.center[2];
      const double toWeight = term.toWeight[k];
      const double weight = term.values[k] * toWeight;
      for (int r = 0; r < 3; ++r) {
        const double moved = row(d.linear + r, x, y, z) + d.shift[r];
        sums.displaced[16 * r + k] += weight * moved;
        for (int c = 0; c < 3; ++c) {
          sums.linear[16 * (3 * r + c) + k] +=
              weight * d.linear[3 * c + r] + toWeight * moved * slopes[16 * c + k];
        }
      }
    }
    add(slopes, sums);
  }

  static void addSlope(const double* points, const InfluenceNumbers& influence, GradientSums& sums) {
    alignas(64) double slopes[48];
    slopesOf(points, influence, slopes);
    add(slopes, sums);
  }

  static constexpr SpaceKernels all{&addDisplacement, &addGradient, &addSlope};

 private:
  /// Copies, which no store can change.
  struct Numbers {
    double center[3];
    double linear[9];
    double shift[3];

    explicit Numbers(const DisplacementNumbers& from) {
      for (int i = 0; i < 3; ++i) {
        center[i] = from.center[i];
        shift[i] = from.shift[i];
      }
      for (int i = 0; i < 9; ++i) {
        linear[i] = from.linear[i];
      }
    }
  };

  static void add(const double* slopes, GradientSums& sums) {
    for (int i = 0; i < 48; ++i) {
      sums.slopes[i] += slopes[i];
    }
  }

  /// Calls visit(slope), slope(uSquared) being that of the basis value over |u|^2.
  template <class Visit>
  static void withSlope(const RadialNumbers& radial, const Visit& visit) {
    if (radial.kernel == 0) {
      visit([](double uSquared) { return Slopes::smooth(uSquared); });
    } else if (radial.kernel == 1) {
      visit([](double uSquared) { return Slopes::wendland(uSquared); });
    } else {
      visit([sigma = radial.sigma](double uSquared) { return Slopes::gaussian(sigma, uSquared); });
    }
  }

  /// grad f at the members and 0 at the others: 2 f'(|u|^2) x toLocal^T u.
  static void slopesOf(const double* points, const InfluenceNumbers& influence, double* slopes) {
    withSlope(influence.radial, [&](const auto& slope) {
      if (influence.region.inverseSquare > 0.0) {
        inSphere(points, influence, slope, slopes);
      } else {
        inEllipsoid(points, influence, slope, slopes);
      }
    });
  }

  /// There toLocal^T u is (v - center) / r^2.
  template <class Slope>
  static void inSphere(const double* points, const InfluenceNumbers& influence, const Slope& slope,
                       double* __restrict__ slopes) {
    const typename Block::Sphere sphere(influence.region);
    const double twice = 2.0 * influence.strength;
    const std::uint64_t members = influence.members;
    for (std::size_t k = 0; k < 16; ++k) {
      const double all = twice * slope(sphere(points, k)) * sphere.inverseSquare;
      const double own = (members & Block::bits[k]) != 0 ? all : 0.0;
      slopes[k] = own * (points[k] - sphere.x);
      slopes[16 + k] = own * (points[16 + k] - sphere.y);
      slopes[32 + k] = own * (points[32 + k] - sphere.z);
    }
  }

  template <class Slope>
  static void inEllipsoid(const double* points, const InfluenceNumbers& influence, const Slope& slope,
                          double* __restrict__ slopes) {
    const typename Block::Ellipsoid region(influence.region);
    const double* const m = region.m;
    const double twice = 2.0 * influence.strength;
    const std::uint64_t members = influence.members;
    for (std::size_t k = 0; k < 16; ++k) {
      const double x = points[k] - region.center[0];
      const double y = points[16 + k] - region.center[1];
      const double z = points[32 + k] - region.center[2];
      const double a = row(m, x, y, z);
      const double b = row(m + 1, x, y, z);
      const double c = row(m + 2, x, y, z);
      const double all = twice * slope(a * a + b * b + c * c);
      const double own = (members & Block::bits[k]) != 0 ? all : 0.0;
      slopes[k] = own * (m[0] * a + m[1] * b + m[2] * c);
      slopes[16 + k] = own * (m[3] * a + m[4] * b + m[5] * c);
      slopes[32 + k] = own * (m[6] * a + m[7] * b + m[8] * c);
    }
  }
};

}  // namespace pbffd
