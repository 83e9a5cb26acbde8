#include "core/mesh/voronoi.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mesh/qhull_delaunay.h"
#include "core/mesh/spread.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace pbffd {
namespace {

/// Sites made fit for Qhull: centred, scaled into [-1, 1], each position once.
struct Prepared {
  Points points;
  std::vector<Index> rows;  ///< of the sites given
  Vec3 center;
  double scale;  ///< given = prepared * scale + center
};

Prepared prepare(const Points& sites) {
  const Vec3 low = sites.colwise().minCoeff();
  const Vec3 high = sites.colwise().maxCoeff();
  Prepared prepared;
  prepared.center = low + 0.5 * (high - low);
  prepared.scale = 0.5 * (high - low).maxCoeff();
  const Points scaled = (sites.rowwise() - prepared.center.transpose()) / prepared.scale;

  std::vector<Index> order(static_cast<std::size_t>(sites.rows()));
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](Index i) { return std::array{scaled(i, 0), scaled(i, 1), scaled(i, 2)}; };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const auto first = key(a);
    const auto second = key(b);
    return first != second ? first < second : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || key(order[i]) != key(order[i - 1])) {
      prepared.rows.push_back(order[i]);
    }
  }
  // In file order, so that Qhull's ways do not depend on where the mesh lies.
  std::sort(prepared.rows.begin(), prepared.rows.end());
  prepared.points.resize(static_cast<Index>(prepared.rows.size()), 3);
  for (std::size_t i = 0; i < prepared.rows.size(); ++i) {
    prepared.points.row(static_cast<Index>(i)) = scaled.row(prepared.rows[i]);
  }
  return prepared;
}

/// Four sites whose volume is a smaller share of that of a brick lie on a circle as far as rounding can tell:
/// any ball through it would do, and those of the cells beside bound it.
constexpr double flatness = 1e-12;

/// The centre of the sphere through the sites of a cell (in the least-squares sense for more than four):
/// 2 (p_i - p_0) . x = |p_i - p_0|^2. Not finite where they lie in a plane.
Vec3 circumcenter(const Points& points, std::span<const Index> sites) {
  const Vec3 origin = points.row(sites[0]);
  if (sites.size() == 4) {
    Mat3 rows;
    for (int i = 0; i < 3; ++i) {
      rows.row(i) = points.row(sites[i + 1]) - origin.transpose();
    }
    const Vec3 right = 0.5 * rows.rowwise().squaredNorm();
    const Vec3 a = rows.row(0);
    const Vec3 b = rows.row(1);
    const Vec3 c = rows.row(2);
    const Vec3 bc = b.cross(c);
    const double volume = a.dot(bc);
    if (std::abs(volume) < flatness * a.norm() * b.norm() * c.norm()) {
      return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    }
    return origin + (right[0] * bc + right[1] * c.cross(a) + right[2] * a.cross(b)) / volume;
  }
  Mat3 normal = Mat3::Zero();
  Vec3 right = Vec3::Zero();
  for (const Index site : sites) {
    const Vec3 offset = points.row(site).transpose() - origin;
    normal += offset * offset.transpose();
    right += 0.5 * offset.squaredNorm() * offset;
  }
  return origin + normal.ldlt().solve(right);
}

VoronoiVertices vertexOfEachCell(const Prepared& prepared, const DelaunayCells& cells) {
  const Index count = cells.size();
  VoronoiVertices vertices;
  vertices.positions.resize(count, 3);
  vertices.siteStart.push_back(0);
  Index kept = 0;
  for (Index c = 0; c < count; ++c) {
    const auto sites = cells[c];
    const Vec3 center = circumcenter(prepared.points, sites);
    const double radius = (prepared.points.row(sites[0]).transpose() - center).norm();
    if (!std::isfinite(radius)) {
      continue;
    }
    vertices.positions.row(kept++) = prepared.scale * center + prepared.center;
    vertices.radii.push_back(prepared.scale * radius);
    for (const Index site : sites) {
      vertices.siteIndices.push_back(prepared.rows[site]);
    }
    vertices.siteStart.push_back(static_cast<Index>(vertices.siteIndices.size()));
  }
  vertices.positions.conservativeResize(kept, 3);
  return vertices;
}

}  // namespace

VoronoiVertices voronoiVertices(const Points& sites, const Progress& progress) {
  progress.throwIfCancelled();
  if (!sites.allFinite()) {
    throw InvalidInput(
        "The Voronoi diagram cannot be made: a site has a coordinate that is not a finite number.");
  }
  if (sites.rows() < 4 || areCoplanar(sites)) {
    throw InvalidInput(
        format("The Voronoi diagram cannot be made: the {} sites lie in a plane.", sites.rows()));
  }
  const Prepared prepared = prepare(sites);
  return vertexOfEachCell(prepared, delaunayCells(prepared.points, progress));
}

}  // namespace pbffd
