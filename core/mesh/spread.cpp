#include "core/mesh/spread.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace pbffd {
namespace {

double extentOf(const Points& points) {
  return points.rows() > 0 ? (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff() : 0.0;
}

/// R of a QR decomposition. Householder reflections keep what squaring in a covariance matrix would lose below
/// 1e-8.
Mat3 triangularFactor(const Points& centred) {
  constexpr Eigen::Index chunk = 4096;
  Mat3 triangle = Mat3::Zero();
  for (Eigen::Index begin = 0; begin < centred.rows(); begin += chunk) {
    const Eigen::Index rows = std::min(chunk, centred.rows() - begin);
    Eigen::MatrixX3d stacked(rows + 3, 3);
    stacked << triangle, centred.middleRows(begin, rows);
    const Eigen::HouseholderQR<Eigen::MatrixX3d> qr(stacked);
    triangle = qr.matrixQR().topRows(3).triangularView<Eigen::Upper>();
  }
  return triangle;
}

}  // namespace

Spread spreadAlongAxes(const Points& points) {
  Spread spread;
  const double extent = extentOf(points);
  if (points.rows() == 0) {
    return spread;
  }
  spread.center =
      points.colwise().minCoeff() + 0.5 * (points.colwise().maxCoeff() - points.colwise().minCoeff());
  if (!(extent > 0.0)) {
    return spread;
  }
  Points centred = (points.rowwise() - spread.center.transpose()) / extent;
  const Vec3 mean = centred.colwise().mean();
  centred.rowwise() -= mean.transpose();
  spread.center += extent * mean;
  const Eigen::JacobiSVD<Mat3> svd(triangularFactor(centred), Eigen::ComputeFullV);
  spread.deviations = extent / std::sqrt(static_cast<double>(points.rows())) * svd.singularValues().reverse();
  spread.axes = svd.matrixV().rowwise().reverse();
  if (spread.axes.determinant() < 0.0) {
    spread.axes.col(0) *= -1.0;
  }
  return spread;
}

Vec3 spreadOf(const Points& points) {
  const Vec3 deviations = spreadAlongAxes(points).deviations;
  return deviations[2] > 0.0 ? Vec3(deviations / deviations[2]) : Vec3::Zero();
}

double roundingShareOf(const Points& points) {
  const double extent = extentOf(points);
  constexpr double least = 1e-13;
  return extent > 0.0 ? std::max(least, 4e-16 * points.cwiseAbs().maxCoeff() / extent) : 1.0;
}

bool areCoplanar(const Points& points) {
  return spreadOf(points)[0] <= roundingShareOf(points);
}

}  // namespace pbffd
