#include "core/mesh/normals.h"

#include <Eigen/Geometry>

namespace pbffd {

Points vertexNormals(const Points& positions, const Triangles& triangles) {
  Points normals = Points::Zero(positions.rows(), 3);
  for (Index t = 0; t < triangles.size(); ++t) {
    const Index* corner = &triangles.vertices()[3 * static_cast<std::size_t>(t)];
    const Vec3 origin = positions.row(corner[0]);
    const Vec3 a = positions.row(corner[1]).transpose() - origin;
    const Vec3 b = positions.row(corner[2]).transpose() - origin;
    const Vec3 weighted = a.cross(b);
    for (int c = 0; c < 3; ++c) {
      normals.row(corner[c]) += weighted.transpose();
    }
  }
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    const double length = normals.row(v).stableNorm();
    if (length > 0.0) {
      normals.row(v) /= length;
    }
  }
  return normals;
}

}  // namespace pbffd
