#include "tests/support/shapes.h"

#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <numbers>

namespace pbffd::test {
namespace {

void addFace(Mesh& mesh, std::initializer_list<Index> corners) {
  mesh.faces.add(std::span<const Index>(corners.begin(), corners.size()));
}

/// A closed tube of rings of vertices with a pole at each end. Ring r, segment s lies at `ring(r, s)`.
Mesh tube(int rings, int segments, const Vec3& first, const Vec3& last,
          const std::function<Vec3(int, int)>& ring) {
  Mesh mesh;
  mesh.positions.resize(rings * segments + 2, 3);
  const Index firstPole = rings * segments;
  const Index lastPole = firstPole + 1;
  mesh.positions.row(firstPole) = first;
  mesh.positions.row(lastPole) = last;
  for (int r = 0; r < rings; ++r) {
    for (int s = 0; s < segments; ++s) {
      const int t = (s + 1) % segments;
      mesh.positions.row(r * segments + s) = ring(r, s);
      if (r == 0) {
        addFace(mesh, {firstPole, t, s});
      }
      if (r + 1 < rings) {
        addFace(mesh, {r * segments + s, r * segments + t, (r + 1) * segments + t, (r + 1) * segments + s});
      } else {
        addFace(mesh, {r * segments + s, r * segments + t, lastPole});
      }
    }
  }
  return mesh;
}

}  // namespace

Mesh cube() {
  Mesh mesh;
  mesh.positions.resize(8, 3);
  for (int i = 0; i < 8; ++i) {
    mesh.positions.row(i) = Vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1).array() - 0.5;
  }
  addFace(mesh, {0, 2, 3, 1});
  addFace(mesh, {4, 5, 7, 6});
  addFace(mesh, {0, 1, 5, 4});
  addFace(mesh, {2, 6, 7, 3});
  addFace(mesh, {0, 4, 6, 2});
  addFace(mesh, {1, 3, 7, 5});
  return mesh;
}

Mesh sphere(int rings, int segments) {
  return tube(rings, segments, -Vec3::UnitX(), Vec3::UnitX(), [&](int r, int s) {
    const double along = std::numbers::pi * (r + 1) / (rings + 1);
    const double around = 2.0 * std::numbers::pi * s / segments;
    return Vec3(-std::cos(along), std::sin(along) * std::cos(around), std::sin(along) * std::sin(around));
  });
}

Mesh cylinder(double length, double radius, int rings, int segments) {
  return tube(rings, segments, Vec3::Zero(), Vec3(length, 0, 0), [&](int r, int s) {
    const double around = 2.0 * std::numbers::pi * s / segments;
    return Vec3(length * r / (rings - 1), radius * std::cos(around), radius * std::sin(around));
  });
}

Mesh sheet(int n) {
  Mesh mesh;
  mesh.positions.resize((n + 1) * (n + 1), 3);
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) {
      mesh.positions.row(y * (n + 1) + x) = Vec3(-1.0 + 2.0 * x / n, -1.0 + 2.0 * y / n, 0.0);
      if (x < n && y < n) {
        const Index at = y * (n + 1) + x;
        addFace(mesh, {at, at + 1, at + n + 2, at + n + 1});
      }
    }
  }
  return mesh;
}

Mesh fork(double gap, int rings, int segments) {
  // A U: the tube's axis runs out along one arm, around the bend and back along the other.
  const double radius = 0.3;
  const double half = radius + 0.5 * gap;
  const double arm = 3.0;
  const double bend = std::numbers::pi * half;
  const auto axis = [=](double t, Vec3& centre, Vec3& side) {
    if (t < arm) {
      centre = Vec3(arm - t, -half, 0);
      side = -Vec3::UnitY();
    } else if (t < arm + bend) {
      const double angle = (t - arm) / half;
      side = Vec3(-std::sin(angle), -std::cos(angle), 0);
      centre = half * side;
    } else {
      centre = Vec3(t - arm - bend, half, 0);
      side = Vec3::UnitY();
    }
  };
  const double total = 2.0 * arm + bend;
  return tube(rings, segments, Vec3(arm, -half, 0), Vec3(arm, half, 0), [&](int r, int s) {
    Vec3 centre;
    Vec3 side;
    axis(total * r / (rings - 1), centre, side);
    const double around = 2.0 * std::numbers::pi * s / segments;
    return Vec3(centre + radius * (std::cos(around) * side - std::sin(around) * Vec3::UnitZ()));
  });
}

Mesh merged(const Mesh& first, const Mesh& second) {
  Mesh mesh = first;
  mesh.positions.conservativeResize(first.positions.rows() + second.positions.rows(), 3);
  mesh.positions.bottomRows(second.positions.rows()) = second.positions;
  for (Index f = 0; f < second.faces.size(); ++f) {
    std::vector<Index> corners(second.faces[f].begin(), second.faces[f].end());
    for (Index& corner : corners) {
      corner += first.vertexCount();
    }
    mesh.faces.add(corners);
  }
  return mesh;
}

Mesh placedAt(Mesh mesh, double scale, const Vec3& shift) {
  mesh.positions = (scale * mesh.positions).rowwise() + shift.transpose();
  return mesh;
}

Mesh triangulated(const Mesh& mesh) {
  Mesh result = mesh;
  result.faces = Polygons();
  const Triangles triangles = triangulate(mesh.positions, mesh.faces);
  for (Index t = 0; t < triangles.size(); ++t) {
    result.faces.add(std::span<const Index>(triangles.vertices()).subspan(3 * t, 3));
  }
  return result;
}

}  // namespace pbffd::test
