#include "resources/samples/generator/surface_net.h"

#include "core/base/parallel.h"

#include <array>
#include <cmath>
#include <limits>

namespace pbffd::samples {
namespace {

constexpr int relaxations = 15;

/// The solid's values at the nodes of a grid that encloses it.
class Grid {
 public:
  Grid(const Solid& solid, double edge) : edge_(edge) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
    for (const Limb& limb : solid.limbs()) {
      for (const Bone& bone : limb.bones) {
        const double radius = std::max(bone.fromRadius, bone.toRadius);
        low = low.cwiseMin((bone.from.cwiseMin(bone.to).array() - radius).matrix());
        high = high.cwiseMax((bone.from.cwiseMax(bone.to).array() + radius).matrix());
      }
    }
    // The blends bulge a little beyond the bones. Half a cell off, so that z = 0 is not a plane of nodes.
    origin_ = (low.array() - 3.5 * edge).matrix();
    size_ = ((high - low) / edge).array().ceil().cast<int>() + 8;
    const int half = static_cast<int>(std::ceil(std::max(-low.z(), high.z()) / edge)) + 4;
    origin_.z() = -(half - 0.5) * edge;
    size_.z() = 2 * half;
    values_.resize(static_cast<std::size_t>(size_.prod()));
    parallelFor(static_cast<std::size_t>(size_.z()), 1, [&](std::size_t begin, std::size_t end) {
      for (auto k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
        for (int j = 0; j < size_.y(); ++j) {
          for (int i = 0; i < size_.x(); ++i) {
            values_[slot({i, j, k})] = solid.value(node({i, j, k}));
          }
        }
      }
    });
  }

  const Eigen::Array3i& size() const { return size_; }
  Vec3 node(const Eigen::Array3i& at) const { return origin_ + edge_ * at.cast<double>().matrix(); }
  std::size_t slot(const Eigen::Array3i& at) const {
    return static_cast<std::size_t>((at.z() * size_.y() + at.y()) * size_.x() + at.x());
  }
  double value(const Eigen::Array3i& at) const { return values_[slot(at)]; }

 private:
  double edge_;
  Vec3 origin_;
  Eigen::Array3i size_;
  std::vector<double> values_;
};

/// Calls body(at) on all nodes but the last `margin` of each row.
template <class Body>
void forEachNode(const Eigen::Array3i& size, int first, int margin, const Body& body) {
  for (int k = first; k + margin < size.z(); ++k) {
    for (int j = first; j + margin < size.y(); ++j) {
      for (int i = first; i + margin < size.x(); ++i) {
        body(Eigen::Array3i(i, j, k));
      }
    }
  }
}

/// The mean of the points where the surface cuts the cell's edges; false where it cuts none.
bool vertexOfCell(const Grid& grid, const Eigen::Array3i& cell, Vec3& vertex) {
  Vec3 sum = Vec3::Zero();
  int crossings = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      Eigen::Array3i from = cell;
      from[(axis + 1) % 3] += corner & 1;
      from[(axis + 2) % 3] += corner >> 1;
      Eigen::Array3i to = from;
      to[axis] += 1;
      const double a = grid.value(from);
      const double b = grid.value(to);
      if ((a < 0.0) != (b < 0.0)) {
        const double share = a / (a - b);
        sum += (1.0 - share) * grid.node(from) + share * grid.node(to);
        ++crossings;
      }
    }
  }
  if (crossings > 0) {
    vertex = sum / crossings;
  }
  return crossings > 0;
}

QuadMesh netOf(const Grid& grid) {
  QuadMesh mesh;
  std::vector<Index> vertexOf(static_cast<std::size_t>(grid.size().prod()), -1);
  std::vector<Vec3> vertices;
  forEachNode(grid.size(), 0, 1, [&](const Eigen::Array3i& cell) {
    Vec3 vertex;
    if (vertexOfCell(grid, cell, vertex)) {
      vertexOf[grid.slot(cell)] = static_cast<Index>(vertices.size());
      vertices.push_back(vertex);
    }
  });
  mesh.positions.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    mesh.positions.row(static_cast<Eigen::Index>(v)) = vertices[v];
  }
  forEachNode(grid.size(), 1, 1, [&](const Eigen::Array3i& from) {
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::Array3i to = from;
      to[axis] += 1;
      const bool fromInside = grid.value(from) < 0.0;
      if (fromInside == (grid.value(to) < 0.0)) {
        continue;
      }
      // The four cells around this edge, counter-clockwise when looked at against the axis.
      std::array<Index, 4> quad;
      for (int c = 0; c < 4; ++c) {
        Eigen::Array3i cell = from;
        cell[(axis + 1) % 3] -= (c == 0 || c == 3) ? 1 : 0;
        cell[(axis + 2) % 3] -= c < 2 ? 1 : 0;
        quad[fromInside ? c : 3 - c] = vertexOf[grid.slot(cell)];
      }
      mesh.faces.add(quad);
    }
  });
  return mesh;
}

/// One Newton step.
Vec3 towardsSurface(const Solid& solid, const Vec3& point) {
  const Vec3 gradient = solid.gradient(point);
  return point - solid.value(point) / std::max(gradient.squaredNorm(), 0.1) * gradient;
}

/// Calls body(v) for every vertex, in parallel.
template <class Body>
void forEachVertex(const QuadMesh& mesh, const Body& body) {
  parallelFor(static_cast<std::size_t>(mesh.positions.rows()), 64, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Eigen::Index>(begin); v < static_cast<Eigen::Index>(end); ++v) {
      body(v);
    }
  });
}

/// Moves every vertex towards the mean of its neighbours, along the surface.
void relax(const Solid& solid, QuadMesh& mesh) {
  Points sums = Points::Zero(mesh.positions.rows(), 3);
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(mesh.positions.rows());
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto quad = mesh.faces[f];
    for (int c = 0; c < 4; ++c) {
      sums.row(quad[c]) += mesh.positions.row(quad[(c + 1) % 4]) + mesh.positions.row(quad[(c + 3) % 4]);
      counts[quad[c]] += 2.0;
    }
  }
  forEachVertex(mesh, [&](Eigen::Index v) {
    const Vec3 point = mesh.positions.row(v);
    const Vec3 towards = sums.row(v).transpose() / counts[v] - point;
    const Vec3 normal = solid.gradient(point).normalized();
    mesh.positions.row(v) =
        towardsSurface(solid, point + 0.7 * (towards - normal.dot(towards) * normal)).transpose();
  });
}

}  // namespace

QuadMesh surfaceNet(const Solid& solid, double edge) {
  QuadMesh mesh = netOf(Grid(solid, edge));
  for (int i = 0; i < relaxations; ++i) {
    relax(solid, mesh);
  }
  forEachVertex(mesh, [&](Eigen::Index v) {
    mesh.positions.row(v) = towardsSurface(solid, mesh.positions.row(v)).transpose();
  });
  return mesh;
}

}  // namespace pbffd::samples
