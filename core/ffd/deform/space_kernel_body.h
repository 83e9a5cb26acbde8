#pragma once

#include "core/ffd/basis_slope_body.h"
#include "core/ffd/deform/space_kernels.h"

namespace pbffd {

/// The loops that all variants share, left to the compiler to turn into each one's instructions; `Here` as in
/// BlockBody.
template <class Here>
struct SpaceBody {
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

  static void radialSlopes(const RadialNumbers& radial, const double* uSquared, double* __restrict__ slopes) {
    if (radial.kernel == 0) {
      for (int k = 0; k < 16; ++k) {
        slopes[k] = Slopes::smooth(uSquared[k]);
      }
    } else if (radial.kernel == 1) {
      for (int k = 0; k < 16; ++k) {
        slopes[k] = Slopes::wendland(uSquared[k]);
      }
    } else {
      const double sigma = radial.sigma;
      for (int k = 0; k < 16; ++k) {
        slopes[k] = Slopes::gaussian(sigma, uSquared[k]);
      }
    }
  }

  /// grad f at the members and 0 at the others: 2 f'(|u|^2) x toLocal^T u.
  static void slopesOf(const double* points, const InfluenceNumbers& influence, double* __restrict__ slopes) {
    alignas(64) double u[48];
    alignas(64) double uSquared[16];
    alignas(64) double radial[16];
    const double* const center = influence.region.center;
    const double* const m = influence.region.toLocal;
    for (int k = 0; k < 16; ++k) {
      const double x = points[k] - center[0];
      const double y = points[16 + k] - center[1];
      const double z = points[32 + k] - center[2];
      u[k] = row(m, x, y, z);
      u[16 + k] = row(m + 1, x, y, z);
      u[32 + k] = row(m + 2, x, y, z);
    }
    BlockBody<Here>::squaredDistances(points, influence.region, uSquared);
    radialSlopes(influence.radial, uSquared, radial);
    const double twice = 2.0 * influence.strength;
    const unsigned members = influence.members;
    for (unsigned k = 0; k < 16; ++k) {
      const double slope = (members >> k & 1U) != 0 ? twice * radial[k] : 0.0;
      for (unsigned c = 0; c < 3; ++c) {
        slopes[16 * c + k] = slope * (m[3 * c] * u[k] + m[3 * c + 1] * u[16 + k] + m[3 * c + 2] * u[32 + k]);
      }
    }
  }
};

}  // namespace pbffd
