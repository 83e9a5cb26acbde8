#include "core/ffd/placement/region_shape.h"

#include "core/base/parallel.h"
#include "core/mesh/nearest.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

namespace pbffd {
namespace {

/// The local distribution is that of so many neighbours.
constexpr int neighbourCount = 8;
/// Fewer points have no distribution to speak of.
constexpr int fewestForShape = 5;
/// No axis is shorter than this share of the longest: flatter regions leave gaps between them.
constexpr double leastShare = 0.4;

/// The distance of the nearest point that stands apart from `center`; none where all are there.
std::optional<double> distanceApart(const NearestPoints& nearest, const Vec3& center, int total) {
  for (int count = 2;; count *= 4) {
    const auto around = nearest.nearest(center, std::min(count, total));
    const auto apart =
        std::find_if(around.begin(), around.end(), [](const auto& one) { return one.distance > 0.0; });
    if (apart != around.end()) {
      return apart->distance;
    }
    if (count >= total) {
      return std::nullopt;
    }
  }
}

/// Axes of unit volume along the principal directions of the neighbours about `center`.
Mat3 shapeOf(const Vec3& center, const Points& points, const std::vector<NearestPoints::Neighbour>& around) {
  const double farthest = around.back().distance;
  if (!(farthest > 0.0)) {
    return Mat3::Identity();
  }
  Mat3 scatter = Mat3::Zero();
  for (const auto& neighbour : around) {
    const Vec3 offset = (points.row(neighbour.index).transpose() - center) / farthest;
    scatter += offset * offset.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(scatter);
  Vec3 lengths = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  lengths = lengths.cwiseMax(leastShare * lengths.maxCoeff());
  lengths /= std::cbrt(lengths.prod());
  // Longest first and right-handed, each axis with its greatest component positive.
  Mat3 axes = solver.eigenvectors().rowwise().reverse();
  lengths.reverseInPlace();
  for (int k = 0; k < 3; ++k) {
    int greatest = 0;
    axes.col(k).cwiseAbs().maxCoeff(&greatest);
    axes.col(k) *= std::copysign(1.0, axes(greatest, k));
  }
  if (axes.determinant() < 0.0) {
    axes.col(2) *= -1.0;
  }
  return axes * lengths.asDiagonal();
}

}  // namespace

std::vector<Frame> regionsOf(const Points& points, double factor, RegionShape shape, double lone) {
  const NearestPoints nearest(points);
  std::vector<Frame> regions(static_cast<std::size_t>(points.rows()));
  parallelFor(regions.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 center = points.row(static_cast<Index>(i));
      const auto total = static_cast<int>(points.rows());
      const double radius = factor * distanceApart(nearest, center, total).value_or(lone);
      if (shape == RegionShape::sphere || total < fewestForShape) {
        regions[i] = {center, radius * Mat3::Identity()};
        continue;
      }
      auto around = nearest.nearest(center, neighbourCount + 1);
      std::erase_if(around, [&](const auto& neighbour) { return neighbour.index == static_cast<Index>(i); });
      regions[i] = {center, radius * shapeOf(center, points, around)};
    }
  });
  return regions;
}

}  // namespace pbffd
