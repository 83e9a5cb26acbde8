#include "core/ffd/frame_checks.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>

namespace pbffd {

bool isFinite(const Frame& frame) {
  return frame.center.allFinite() && frame.axes.allFinite();
}

bool isInvertible(const Mat3& linear) {
  const Vec3 lengths = linear.colwise().norm().transpose();
  if (!linear.allFinite() || !lengths.allFinite()) {
    return false;
  }
  // Most are far from the limit, and cheaply seen to be.
  const double longest = lengths.maxCoeff();
  if (lengths.minCoeff() > 1e-3 * longest &&
      std::abs((linear / longest).determinant()) > 1e-6 * (lengths / longest).prod()) {
    return true;
  }
  if (longest == 0.0) {
    return false;
  }
  const Vec3 stretches = Eigen::JacobiSVD<Mat3>(linear / longest).singularValues();
  return stretches[2] > 1e-12 * stretches[0];
}

bool areOrthogonal(const Mat3& axes) {
  constexpr double tolerance = 1e-9;
  const Vec3 lengths = axes.colwise().norm().transpose();
  const Mat3 products = axes.transpose() * axes;
  return std::abs(products(0, 1)) <= tolerance * lengths[0] * lengths[1] &&
         std::abs(products(0, 2)) <= tolerance * lengths[0] * lengths[2] &&
         std::abs(products(1, 2)) <= tolerance * lengths[1] * lengths[2];
}

bool haveLengths(const Mat3& axes) {
  for (int k = 0; k < 3; ++k) {
    const double squared = axes.col(k).squaredNorm();
    if (!std::isnormal(squared) || !std::isnormal(1.0 / squared)) {
      return false;
    }
  }
  return true;
}

}  // namespace pbffd
