#include "core/ffd/levels/enclosing_region.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pbffd {
namespace {

using Mat4 = Eigen::Matrix4d;

/// The six numbers of the symmetric quadric Q of x^T Q x <= 1, then a multiplier for each of the two regions.
constexpr int unknowns = 8;
using Unknowns = Eigen::Matrix<double, unknowns, 1>;
using Curvature = Eigen::Matrix<double, unknowns, unknowns>;

double largestSemiAxis(const Frame& rest) {
  return rest.axes.colwise().norm().maxCoeff();
}

double enclosingRadius(const Frame& first, const Frame& second) {
  return 0.5 * (first.center - second.center).norm() +
         std::max(largestSemiAxis(first), largestSemiAxis(second));
}

Mat3 quadricOf(const Unknowns& z) {
  Mat3 q;
  q << z[0], z[1], z[2], z[1], z[3], z[4], z[2], z[4], z[5];
  return q;
}

/// The least ellipsoid about the origin that encloses two others, as a problem over matrices: minimise
/// -log det Q where, by the S-lemma, {c + A s, |s| <= 1} lies within x^T Q x <= 1 if and only if
/// F = [m I - A^T Q A, -A^T Q c; -c^T Q A, 1 - m - c^T Q c] is positive for some multiplier m. Solved by an
/// interior point method, so that what it ends with encloses both, however far it came.
class LeastEllipsoid {
 public:
  explicit LeastEllipsoid(const std::array<Frame, 2>& inner) : inner_(inner) {
    for (int k = 0; k < unknowns; ++k) {
      const Unknowns unit = Unknowns::Unit(k);
      quadrics_[k] = quadricOf(unit);
      conditions_[0][k] = condition(0, unit, 0.0);
      conditions_[1][k] = condition(1, unit, 0.0);
    }
  }

  /// For regions within the unit sphere about the origin.
  Mat3 solve() const {
    Unknowns z;
    z << 0.25, 0, 0, 0.25, 0, 0.25, 0.5, 0.5;
    // The volume that is left to gain is below 4 times the last share.
    for (double share = 1.0; share > 1e-7; share *= 0.05) {
      z = minimized(z, share);
    }
    return quadricOf(z);
  }

 private:
  /// F of one region, linear in the unknowns but for the 1.
  Mat4 condition(int which, const Unknowns& z, double constant) const {
    const Frame& region = inner_[which];
    const Mat3 q = quadricOf(z);
    const double multiplier = z[6 + which];
    Mat4 f;
    f.topLeftCorner<3, 3>() = multiplier * Mat3::Identity() - region.axes.transpose() * q * region.axes;
    f.topRightCorner<3, 1>() = -region.axes.transpose() * q * region.center;
    f.bottomLeftCorner<1, 3>() = f.topRightCorner<3, 1>().transpose();
    f(3, 3) = constant - multiplier - region.center.dot(q * region.center);
    return f;
  }

  /// -log det of a symmetric matrix; infinity where it is not positive.
  template <class Matrix>
  static double minusLogDeterminant(const Matrix& matrix) {
    const Eigen::LLT<Matrix> factor(matrix);
    if (factor.info() != Eigen::Success) {
      return std::numeric_limits<double>::infinity();
    }
    return -2.0 * Matrix(factor.matrixL()).diagonal().array().log().sum();
  }

  double value(const Unknowns& z, double share) const {
    return minusLogDeterminant(quadricOf(z)) +
           share * (minusLogDeterminant(condition(0, z, 1.0)) + minusLogDeterminant(condition(1, z, 1.0)));
  }

  struct Derivatives {
    Unknowns gradient = Unknowns::Zero();
    Curvature hessian = Curvature::Zero();  ///< its lower triangle

    /// Adds those of -weight * log det of a matrix, given how it changes with each unknown.
    template <class Matrix>
    void add(const Matrix& matrix, const std::array<Matrix, unknowns>& changes, double weight) {
      const Matrix inverse = matrix.inverse();
      std::array<Matrix, unknowns> solved;
      for (int k = 0; k < unknowns; ++k) {
        solved[k].noalias() = inverse * changes[k];
        gradient[k] -= weight * solved[k].trace();
      }
      for (int k = 0; k < unknowns; ++k) {
        for (int l = 0; l <= k; ++l) {
          hessian(k, l) += weight * solved[k].cwiseProduct(solved[l].transpose()).sum();
        }
      }
    }
  };

  Derivatives derivatives(const Unknowns& z, double share) const {
    Derivatives sum;
    sum.add(quadricOf(z), quadrics_, 1.0);
    sum.add(condition(0, z, 1.0), conditions_[0], share);
    sum.add(condition(1, z, 1.0), conditions_[1], share);
    return sum;
  }

  /// Newton's method with halved steps; never leaves the interior.
  Unknowns minimized(Unknowns z, double share) const {
    constexpr int iterations = 50;
    constexpr double shortest = 1e-10;
    for (int i = 0; i < iterations; ++i) {
      const Derivatives at = derivatives(z, share);
      const Unknowns step = -at.hessian.ldlt().solve(at.gradient);
      const double slope = at.gradient.dot(step);
      // What the share leaves undecided anyway is near enough.
      if (!(-slope > share)) {
        break;
      }
      const double before = value(z, share);
      double length = 1.0;
      while (length > shortest && !(value(z + length * step, share) <= before + 0.1 * length * slope)) {
        length *= 0.5;
      }
      if (length <= shortest) {
        break;
      }
      z += length * step;
    }
    return z;
  }

  const std::array<Frame, 2>& inner_;
  /// How the quadric and the conditions change with each unknown.
  std::array<Mat3, unknowns> quadrics_;
  std::array<std::array<Mat4, unknowns>, 2> conditions_;
};

Frame enclosingEllipsoid(const Frame& first, const Frame& second) {
  const Vec3 center = 0.5 * (first.center + second.center);
  const double radius = enclosingRadius(first, second);
  const std::array<Frame, 2> scaled{Frame{(first.center - center) / radius, first.axes / radius},
                                    Frame{(second.center - center) / radius, second.axes / radius}};
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(LeastEllipsoid(scaled).solve());
  Frame frame{center, solver.eigenvectors()};
  for (int axis = 0; axis < 3; ++axis) {
    frame.axes.col(axis) *= radius / std::sqrt(solver.eigenvalues()[axis]);
  }
  return frame;
}

}  // namespace

Frame enclosingRegion(const Frame& first, const Frame& second, RegionShape shape) {
  if (shape == RegionShape::ellipsoid) {
    return enclosingEllipsoid(first, second);
  }
  return {0.5 * (first.center + second.center), enclosingRadius(first, second) * Mat3::Identity()};
}

}  // namespace pbffd
