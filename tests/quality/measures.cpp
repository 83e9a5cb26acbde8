#include "tests/quality/measures.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace pbffd::test {
namespace {

using Corners = std::array<Vec3, 3>;

Corners cornersOf(const Points& points, const Triangles& triangles, Index t) {
  return {points.row(triangles.vertices()[3 * t]), points.row(triangles.vertices()[3 * t + 1]),
          points.row(triangles.vertices()[3 * t + 2])};
}

/// The triangle's edges in its own plane, 2 x 2.
Eigen::Matrix2d flat(const Corners& corners) {
  const Vec3 a = corners[1] - corners[0];
  const Vec3 b = corners[2] - corners[0];
  const Vec3 x = a.normalized();
  const Vec3 y = a.cross(b).cross(a).normalized();
  Eigen::Matrix2d edges;
  edges << a.dot(x), b.dot(x), a.dot(y), b.dot(y);
  return edges;
}

double stretch(const Corners& rest, const Corners& deformed) {
  const Eigen::Matrix2d gradient = flat(deformed) * flat(rest).inverse();
  const Eigen::Vector2d s = gradient.jacobiSvd().singularValues();
  return std::max(s[0], 1.0 / s[1]);
}

Vec3 normalOf(const Corners& corners) {
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
}

double angle(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::numbers::pi;
}

/// The pairs of triangles that share an edge.
std::vector<std::pair<Index, Index>> neighbours(const Triangles& triangles) {
  std::map<std::pair<Index, Index>, Index> open;
  std::vector<std::pair<Index, Index>> pairs;
  for (Index t = 0; t < triangles.size(); ++t) {
    for (int c = 0; c < 3; ++c) {
      const auto edge = std::minmax(triangles.vertices()[3 * t + c], triangles.vertices()[3 * t + (c + 1) % 3]);
      const auto [at, isNew] = open.try_emplace(edge, t);
      if (!isNew) {
        pairs.emplace_back(at->second, t);
      }
    }
  }
  return pairs;
}

double percentile(std::vector<double> values, double share) {
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

}  // namespace

double volume(const Points& points, const Triangles& triangles) {
  double sum = 0.0;
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = cornersOf(points, triangles, t);
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

Quality measure(const Points& rest, const Points& deformed, const Triangles& triangles) {
  Quality quality;
  const double before = volume(rest, triangles);
  quality.volumeChange = 100.0 * (volume(deformed, triangles) - before) / before;
  std::vector<double> stretches;
  for (Index t = 0; t < triangles.size(); ++t) {
    stretches.push_back(stretch(cornersOf(rest, triangles, t), cornersOf(deformed, triangles, t)));
  }
  quality.stretch95 = percentile(stretches, 0.95);
  quality.stretchMax = *std::max_element(stretches.begin(), stretches.end());
  std::vector<double> jumps;
  for (const auto& [s, t] : neighbours(triangles)) {
    const auto between = [&, s = s, t = t](const Points& points) {
      return angle(normalOf(cornersOf(points, triangles, s)), normalOf(cornersOf(points, triangles, t)));
    };
    const double jump = std::abs(between(deformed) - between(rest));
    jumps.push_back(jump);
    quality.folds += jump > 120.0;
  }
  quality.jump99 = percentile(jumps, 0.99);
  return quality;
}

Deviation deviation(const Points& shape, const Points& wanted, double diagonal) {
  const Eigen::VectorXd distances = (shape - wanted).rowwise().norm();
  const double percent = 100.0 / diagonal;
  return {percent * std::sqrt(distances.squaredNorm() / static_cast<double>(distances.size())),
          percent * distances.maxCoeff()};
}

}  // namespace pbffd::test
