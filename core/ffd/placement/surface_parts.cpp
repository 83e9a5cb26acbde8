#include "core/ffd/placement/surface_parts.h"

#include "core/base/parallel.h"
#include "core/ffd/placement/mesh_parts.h"
#include "core/mesh/morton.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>

namespace pbffd {
namespace {

Points rowsOf(const Points& points, const std::vector<Index>& rows) {
  Points some(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    some.row(static_cast<Eigen::Index>(i)) = points.row(rows[i]);
  }
  return some;
}

}  // namespace

SurfaceParts::SurfaceParts(std::shared_ptr<const RestMesh> mesh, Surface how) : mesh_(std::move(mesh)) {
  MeshParts parts = meshParts(*mesh_);
  isWhole_ = parts.isClosed;
  isClosed_ = std::move(parts.isClosed);
  if (how == Surface::automatic) {
    inconsistentCount_ = parts.inconsistentCount;
  } else {
    isClosed_.assign(isClosed_.size(), how == Surface::closed);
  }
  isTurned_.assign(isClosed_.size(), false);
  nameParts(parts.ofFace);
  measure();
  inside_ = std::make_unique<Lazy<WindingNumber>>();
  turnPartsInsideOut();
  if (countOf(false) > 0) {
    const Triangles& triangles = mesh_->triangles();
    std::vector<Index> corners;
    for (Index t = 0; t < triangles.size(); ++t) {
      if (!isClosed_[partOfTriangle_[t]]) {
        corners.insert(corners.end(), &triangles.vertices()[3 * t], &triangles.vertices()[3 * t] + 3);
      }
    }
    openParts_ = std::make_unique<TriangleTree>(workingPositions(), corners);
  }
}

void SurfaceParts::nameParts(const std::vector<Index>& partOfFace) {
  const Polygons& faces = mesh_->mesh().faces;
  partOfVertex_.assign(static_cast<std::size_t>(mesh_->vertexCount()), -1);
  for (Index f = 0; f < faces.size(); ++f) {
    for (const Index vertex : faces[f]) {
      partOfVertex_[vertex] = partOfFace[f];
    }
  }
  const Triangles& triangles = mesh_->triangles();
  partOfTriangle_.reserve(static_cast<std::size_t>(triangles.size()));
  for (Index t = 0; t < triangles.size(); ++t) {
    partOfTriangle_.push_back(partOfFace[triangles.faceOf(t)]);
  }
}

void SurfaceParts::measure() {
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh_->vertexCount(); ++v) {
    if (partOfVertex_[v] >= 0) {
      vertices.push_back(v);
    }
  }
  const Points surface = rowsOf(mesh_->positions(), vertices);
  bounds_ = boundsOf(surface);
  round_ = RoundSpace::of(mesh_->positions(), surface);
  const Triangles& triangles = mesh_->triangles();
  const Vec3 center = bounds_.center();
  area_.assign(isClosed_.size(), 0.0);
  signedVolume_.assign(isClosed_.size(), 0.0);
  for (Index t = 0; t < triangles.size(); ++t) {
    Vec3 p[3];
    for (int k = 0; k < 3; ++k) {
      p[k] = mesh_->positions().row(triangles.vertices()[3 * t + k]).transpose() - center;
    }
    const Vec3 twice = (p[1] - p[0]).cross(p[2] - p[0]);
    area_[partOfTriangle_[t]] += 0.5 * twice.norm();
    signedVolume_[partOfTriangle_[t]] += p[0].dot(twice) / 6.0;
  }
  for (std::size_t part = 0; part < isClosed_.size(); ++part) {
    volume_ += isClosed_[part] ? signedVolume_[part] : 0.0;
  }
  volume_ = std::abs(volume_);
}

std::vector<Index> SurfaceParts::closedCorners() const {
  const std::span<const Index> vertices = mesh_->triangles().vertices();
  std::vector<Index> corners;
  corners.reserve(vertices.size());
  for (std::size_t t = 0; t < partOfTriangle_.size(); ++t) {
    if (isClosed_[partOfTriangle_[t]]) {
      const bool isTurned = isTurned_[partOfTriangle_[t]];
      corners.push_back(vertices[3 * t]);
      corners.push_back(vertices[3 * t + (isTurned ? 2 : 1)]);
      corners.push_back(vertices[3 * t + (isTurned ? 1 : 2)]);
    }
  }
  return corners;
}

/// Whether the winding number behind a triangle is below that of nothing.
bool SurfaceParts::isInsideOut(Index triangle) const {
  constexpr double step = 1e-6;
  const auto at = [&](int k) -> Vec3 {
    return workingPositions().row(mesh_->triangles().vertices()[3 * triangle + k]);
  };
  const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).stableNormalized();
  const double size = round_ ? 1.0 : diagonal();
  return inside().at((at(0) + at(1) + at(2)) / 3.0 + step * size * normal) < -0.5;
}

/// A part of negative volume is the wall of a hollow, or it lies inside out: then the winding number behind
/// its faces is -1, where in the solid around a hollow it is 1.
void SurfaceParts::turnPartsInsideOut() {
  const Triangles& triangles = mesh_->triangles();
  std::vector<Index> largest(isClosed_.size(), -1);
  std::vector<double> size(isClosed_.size(), 0.0);
  for (Index t = 0; t < triangles.size(); ++t) {
    const Index part = partOfTriangle_[t];
    if (!isClosed_[part] || signedVolume_[part] >= 0.0) {
      continue;
    }
    const auto at = [&](int k) -> Vec3 { return mesh_->positions().row(triangles.vertices()[3 * t + k]); };
    if (const double area = (at(1) - at(0)).cross(at(2) - at(0)).norm(); area > size[part]) {
      size[part] = area;
      largest[part] = t;
    }
  }
  bool anyTurned = false;
  for (std::size_t part = 0; part < largest.size(); ++part) {
    if (largest[part] >= 0) {
      isTurned_[part] = isInsideOut(largest[part]);
      anyTurned = anyTurned || isTurned_[part];
    }
  }
  if (anyTurned) {
    inside_ = std::make_unique<Lazy<WindingNumber>>();
    volume_ = 0.0;
    for (std::size_t part = 0; part < isClosed_.size(); ++part) {
      volume_ += isClosed_[part] ? (isTurned_[part] ? -signedVolume_[part] : signedVolume_[part]) : 0.0;
    }
    volume_ = std::abs(volume_);
  }
}

double SurfaceParts::areaOf(bool closed) const {
  double sum = 0.0;
  for (std::size_t part = 0; part < area_.size(); ++part) {
    sum += isClosed_[part] == closed ? area_[part] : 0.0;
  }
  return sum;
}

Index SurfaceParts::countOf(bool closed) const {
  return static_cast<Index>(std::count(isClosed_.begin(), isClosed_.end(), closed));
}

Vec3 SurfaceParts::vertexNormal(Index vertex) const {
  const Index part = partOfVertex_[vertex];
  const Vec3 normal = mesh_->normals().row(vertex);
  return part >= 0 && isTurned_[part] ? Vec3(-normal) : normal;
}

Vec3 SurfaceParts::triangleNormal(Index triangle) const {
  const std::span<const Index> vertices = mesh_->triangles().vertices();
  const auto at = [&](int k) -> Vec3 { return mesh_->positions().row(vertices[3 * triangle + k]); };
  const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).stableNormalized();
  return isTurned_[partOfTriangle_[triangle]] ? Vec3(-normal) : normal;
}

const WindingNumber& SurfaceParts::inside() const {
  return inside_->get([&] {
    const bool areAsTheyAre =
        countOf(false) == 0 && std::find(isTurned_.begin(), isTurned_.end(), true) == isTurned_.end();
    return areAsTheyAre ? WindingNumber(workingPositions(), mesh_->triangles().vertices())
                        : WindingNumber(workingPositions(), closedCorners());
  });
}

std::vector<bool> SurfaceParts::insideFlags(const Points& points, const Progress& progress) const {
  // Near ones one after the other: they look at the same parts of the surface.
  const std::vector<Index> order = mortonOrderOf(points, mesh_->bounds());
  std::vector<std::uint8_t> flags(order.size());
  parallelFor(flags.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress.isCancelled(); ++i) {
      flags[order[i]] = isInside(points.row(order[i]));
    }
  });
  progress.throwIfCancelled();
  return {flags.begin(), flags.end()};
}

std::vector<bool> SurfaceParts::likelyInsideFlags(const Points& points, const Progress& progress) const {
  // Through a hole a point comes in without meeting a wall.
  if (!std::equal(isClosed_.begin(), isClosed_.end(), isWhole_.begin(), std::less_equal<>())) {
    return insideFlags(points, progress);
  }
  const std::vector<std::uint8_t> flags = flagsAlong(mortonOrderOf(points, mesh_->bounds()), points, progress);
  progress.throwIfCancelled();
  return flags.empty() ? insideFlags(points, progress) : std::vector<bool>(flags.begin(), flags.end());
}

/// Along the order from point to point; none where a check fails.
std::vector<std::uint8_t> SurfaceParts::flagsAlong(const std::vector<Index>& order, const Points& points,
                                                   const Progress& progress) const {
  constexpr std::size_t run = 128;
  constexpr std::size_t pointsToCheck = 16;
  const TriangleTree& walls = inside().triangles();
  // Out there, far off, crossings would be rounded away.
  const auto isBeyond = [&](const Vec3& point) {
    return (point.array() < bounds_.low.array()).any() || (point.array() > bounds_.high.array()).any();
  };
  std::vector<std::uint8_t> flags(order.size(), 0);
  std::atomic<bool> isRight = true;
  parallelFor((order.size() + run - 1) / run, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * run; i < std::min(end * run, order.size()) && isRight; ++i) {
      if (progress.isCancelled()) {
        return;
      }
      const Vec3 point = points.row(order[i]);
      if (isBeyond(point)) {
        continue;
      }
      const Vec3 before = points.row(order[i - (i % run == 0 ? 0 : 1)]);
      const bool isApart = i % run == 0 || isBeyond(before) || walls.isCrossed(working(before), working(point));
      const bool isCheck = i % pointsToCheck == 0;
      const bool isIn = isApart || isCheck ? isInside(point) : flags[order[i - 1]] != 0;
      if (isCheck && !isApart && isIn != (flags[order[i - 1]] != 0)) {
        isRight = false;
      }
      flags[order[i]] = isIn;
    }
  });
  return isRight ? flags : std::vector<std::uint8_t>();
}

bool SurfaceParts::isBetween(const Vec3& from, const Vec3& to) const {
  const Vec3 a = working(from);
  const Vec3 b = working(to);
  return inside().triangles().isCrossed(a, b) || (openParts_ && openParts_->isCrossed(a, b));
}

}  // namespace pbffd
