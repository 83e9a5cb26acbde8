#include "core/ffd/enclosing_region.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pbffd {
namespace {

double largestSemiAxis(const Frame& rest) {
  return rest.axes.colwise().norm().maxCoeff();
}

Frame enclosingSphere(const Frame& first, const Frame& second) {
  const double radius =
      0.5 * (first.center - second.center).norm() + std::max(largestSemiAxis(first), largestSemiAxis(second));
  return {0.5 * (first.center + second.center), radius * Mat3::Identity()};
}

/// The point of the ellipsoid center + axes * (unit sphere) that lies farthest out of x^T Q x = 1, and how far:
/// maximises |b + B t| over |t| = 1 by its secular equation in the multiplier.
struct Farthest {
  Vec3 point;
  double value;  ///< x^T Q x
};
Farthest farthest(const Frame& ellipsoid, const Mat3& quadric) {
  const Mat3 root = quadric.llt().matrixU();
  const Eigen::JacobiSVD<Mat3> svd(root * ellipsoid.axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vec3 sigma = svd.singularValues();
  const Vec3 pull = sigma.cwiseProduct(svd.matrixU().transpose() * (root * ellipsoid.center));
  const Vec3 squares = sigma.cwiseAbs2();
  const auto at = [&](double multiplier) -> Vec3 {
    Vec3 t;
    for (int i = 0; i < 3; ++i) {
      const double gap = multiplier - squares[i];
      t[i] = gap > 0.0 ? pull[i] / gap : 0.0;
    }
    return t;
  };
  // |t| falls from the largest sigma^2 on; at the upper end it is below 1.
  double low = squares[0];
  double high = squares[0] + pull.norm();
  for (int i = 0; i < 100 && high - low > 1e-15 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (at(middle).norm() > 1.0 ? low : high) = middle;
  }
  Vec3 t = at(high);
  // Without a pull along the longest axis the rest of the unit lies along it, on either side.
  const double missing = 1.0 - t.squaredNorm();
  if (missing > 0.0) {
    t[0] = std::copysign(std::sqrt(t[0] * t[0] + missing), t[0]);
  }
  const Vec3 point = ellipsoid.center + ellipsoid.axes * (svd.matrixV() * t.normalized());
  return {point, point.dot(quadric * point)};
}

/// The quadric of the least ellipsoid about the origin that holds the points (and their opposites): the
/// Wolfe-Atwood algorithm with away steps (Todd and Yildirim 2007).
Mat3 leastQuadric(const std::vector<Vec3>& points, std::vector<double>& shares) {
  constexpr double dimension = 3.0;
  constexpr double tolerance = 1e-8;
  Mat3 inverse = Mat3::Identity();
  for (int iteration = 0; iteration < 10000; ++iteration) {
    Mat3 scatter = Mat3::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      scatter += shares[i] * points[i] * points[i].transpose();
    }
    inverse = scatter.inverse();
    std::size_t outermost = 0;
    std::size_t innermost = points.size();
    std::vector<double> distance(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      distance[i] = points[i].dot(inverse * points[i]);
      if (distance[i] > distance[outermost]) {
        outermost = i;
      }
      if (shares[i] > 0.0 && (innermost == points.size() || distance[i] < distance[innermost])) {
        innermost = i;
      }
    }
    const double above = distance[outermost] / dimension - 1.0;
    const double below = 1.0 - distance[innermost] / dimension;
    if (std::max(above, below) < tolerance) {
      break;
    }
    const std::size_t chosen = above >= below ? outermost : innermost;
    double step = (distance[chosen] - dimension) / (dimension * (distance[chosen] - 1.0));
    if (above < below) {
      // An away step takes at most the whole share of the innermost point.
      const double most = -shares[chosen] / (1.0 - shares[chosen]);
      step = distance[chosen] > 1.0 ? std::max(step, most) : most;
    }
    for (double& share : shares) {
      share *= 1.0 - step;
    }
    shares[chosen] = std::max(0.0, shares[chosen] + step);
  }
  return inverse / dimension;
}

Frame enclosingEllipsoid(const Frame& first, const Frame& second) {
  const Vec3 center = 0.5 * (first.center + second.center);
  const std::array<Frame, 2> ellipsoids{Frame{first.center - center, first.axes},
                                        Frame{second.center - center, second.axes}};
  std::vector<Vec3> points;
  for (const Frame& ellipsoid : ellipsoids) {
    for (int axis = 0; axis < 3; ++axis) {
      points.push_back(ellipsoid.center + ellipsoid.axes.col(axis));
      points.push_back(ellipsoid.center - ellipsoid.axes.col(axis));
    }
  }
  std::vector<double> shares(points.size(), 1.0 / static_cast<double>(points.size()));
  Mat3 quadric;
  double outside = 1.0;
  // The points where the two touch it from within are found one after the other.
  for (int round = 0; round < 100; ++round) {
    quadric = leastQuadric(points, shares);
    const std::array<Farthest, 2> found{farthest(ellipsoids[0], quadric), farthest(ellipsoids[1], quadric)};
    outside = std::max(found[0].value, found[1].value);
    if (outside < 1.0 + 1e-7) {
      break;
    }
    for (const Farthest& one : found) {
      points.push_back(one.point);
      shares.push_back(0.0);
    }
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(quadric / std::max(outside, 1.0));
  Frame frame{center, solver.eigenvectors()};
  for (int axis = 0; axis < 3; ++axis) {
    frame.axes.col(axis) /= std::sqrt(solver.eigenvalues()[axis]);
  }
  return frame;
}

}  // namespace

Frame enclosingRegion(const Frame& first, const Frame& second, RegionShape shape) {
  return shape == RegionShape::sphere ? enclosingSphere(first, second) : enclosingEllipsoid(first, second);
}

}  // namespace pbffd
