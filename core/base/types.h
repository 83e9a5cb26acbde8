#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace pbffd {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// N x 3, row i = point i, in mesh units.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// A row of a table: a vertex, a face, a place in a list of control points.
using Index = std::int32_t;

/// The permanent identifier of a control point within a project; never reused. 0 names no point.
using PointId = std::int64_t;

/// An affine map of space, 3 x 4: x -> M.leftCols<3>() * x + M.col(3).
using AffineMap = Eigen::Matrix<double, 3, 4>;

}  // namespace pbffd
