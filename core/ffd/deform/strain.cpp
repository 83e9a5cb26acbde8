#include "core/ffd/deform/strain.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace pbffd {

Strain strainOf(const Mat3& gradient) {
  const Eigen::JacobiSVD<Mat3> svd(gradient);
  return {svd.singularValues(), gradient.determinant()};
}

Vec3 carriedTangent(const Mat3& gradient, const Vec3& tangent) {
  return gradient * tangent;
}

Vec3 carriedNormal(const Mat3& gradient, const Vec3& normal) {
  Mat3 cofactors;
  for (int k = 0; k < 3; ++k) {
    cofactors.col(k) = gradient.col((k + 1) % 3).cross(gradient.col((k + 2) % 3));
  }
  const Vec3 carried = cofactors * normal;
  const double length = carried.stableNorm();
  return length > 0.0 ? Vec3(carried / length) : Vec3(Vec3::Zero());
}

Mat3 carriedRotation(const Mat3& gradient) {
  const Eigen::JacobiSVD<Mat3> svd(gradient, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return svd.matrixU() * Vec3(1.0, 1.0, sign).asDiagonal() * svd.matrixV().transpose();
}

}  // namespace pbffd
