#include "core/mesh/mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace pbffd {
namespace {

using Corner = Eigen::Vector2d;

double cross(const Corner& a, const Corner& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double turn(const Corner& a, const Corner& b, const Corner& c) {
  return cross(b - a, c - b);
}

/// The polygon seen along its normal (Newell's), counter-clockwise, about its first corner.
std::vector<Corner> flattened(const Points& positions, std::span<const Index> face) {
  const Vec3 origin = positions.row(face[0]);
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Vec3 a = positions.row(face[i]).transpose() - origin;
    const Vec3 b = positions.row(face[(i + 1) % face.size()]).transpose() - origin;
    normal += a.cross(b);
  }
  const double length = normal.norm();
  const Vec3 n = length > 0.0 ? Vec3(normal / length) : Vec3::UnitZ();
  const Vec3 u = n.unitOrthogonal();
  const Vec3 v = n.cross(u);
  std::vector<Corner> corners;
  corners.reserve(face.size());
  for (const Index vertex : face) {
    const Vec3 offset = positions.row(vertex).transpose() - origin;
    corners.emplace_back(offset.dot(u), offset.dot(v));
  }
  return corners;
}

/// Whether every triangle of the fan from the first corner turns the right way.
bool isFan(const std::vector<Corner>& corners) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    if (cross(corners[i] - corners[0], corners[i + 1] - corners[0]) < 0.0) {
      return false;
    }
  }
  return true;
}

bool isInside(const Corner& p, const Corner& a, const Corner& b, const Corner& c) {
  return cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0;
}

bool isEar(const std::vector<Corner>& corners, const std::vector<int>& ring, std::size_t at) {
  const std::size_t n = ring.size();
  const Corner& a = corners[ring[(at + n - 1) % n]];
  const Corner& b = corners[ring[at]];
  const Corner& c = corners[ring[(at + 1) % n]];
  if (turn(a, b, c) <= 0.0) {
    return false;
  }
  return std::none_of(ring.begin(), ring.end(), [&](int other) {
    const Corner& p = corners[other];
    return p != a && p != b && p != c && isInside(p, a, b, c);
  });
}

/// The longest polygon whose ears are cut; the quadratic search would not end on longer ones, which are
/// fanned like those that have no ear left.
constexpr std::size_t longestToCut = 2000;

/// Ear clipping; what has no ear left (a polygon that crosses itself) is fanned.
std::vector<std::array<int, 3>> cutEars(const std::vector<Corner>& corners) {
  std::vector<int> ring(corners.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    ring[i] = static_cast<int>(i);
  }
  std::vector<std::array<int, 3>> triangles;
  while (ring.size() > 3 && corners.size() <= longestToCut) {
    std::size_t ear = 0;
    while (ear < ring.size() && !isEar(corners, ring, ear)) {
      ++ear;
    }
    if (ear == ring.size()) {
      break;
    }
    const std::size_t n = ring.size();
    triangles.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    triangles.push_back({ring[0], ring[i], ring[i + 1]});
  }
  return triangles;
}

/// Triangles while they are collected.
struct CutFaces {
  std::vector<Index> vertices;        ///< 3 a triangle
  std::vector<Index> faceOfTriangle;  ///< one a triangle

  void add(Index face, Index a, Index b, Index c) {
    vertices.insert(vertices.end(), {a, b, c});
    faceOfTriangle.push_back(face);
  }
};

void addPolygon(CutFaces& triangles, const Points& positions, std::span<const Index> corners, Index face) {
  const std::vector<Corner> flat = flattened(positions, corners);
  if (isFan(flat)) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      triangles.add(face, corners[0], corners[i], corners[i + 1]);
    }
    return;
  }
  for (const auto& [a, b, c] : cutEars(flat)) {
    triangles.add(face, corners[a], corners[b], corners[c]);
  }
}

bool areTriangles(const Polygons& faces) {
  for (Index f = 0; f < faces.size(); ++f) {
    if (faces[f].size() != 3) {
      return false;
    }
  }
  return true;
}

}  // namespace

Triangles triangulate(const Points& positions, const Polygons& faces) {
  if (areTriangles(faces)) {
    return Triangles(faces);
  }
  CutFaces triangles;
  const std::size_t corners = faces.vertices().size();
  const std::size_t count = static_cast<std::size_t>(faces.size());
  const std::size_t expected = corners > 2 * count ? corners - 2 * count : 0;
  triangles.vertices.reserve(3 * expected);
  triangles.faceOfTriangle.reserve(expected);
  for (Index f = 0; f < faces.size(); ++f) {
    const std::span<const Index> face = faces[f];
    if (face.size() == 3) {
      triangles.add(f, face[0], face[1], face[2]);
    } else if (face.size() > 3) {
      addPolygon(triangles, positions, face, f);
    }
  }
  return {std::move(triangles.vertices), std::move(triangles.faceOfTriangle)};
}

}  // namespace pbffd
