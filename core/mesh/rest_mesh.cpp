#include "core/mesh/rest_mesh.h"

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>

namespace pbffd {
namespace {

/// A value made when first asked for, by whichever thread comes first.
template <class Value>
class Lazy {
 public:
  template <class Make>
  const Value& get(Make&& make) {
    std::call_once(once_, [&] { value_.emplace(make()); });
    return *value_;
  }

 private:
  std::once_flag once_;
  std::optional<Value> value_;
};

/// Spreads the low 21 bits so that two zeros follow each.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

std::vector<Index> mortonOrderOf(const Points& positions, const Bounds& bounds) {
  const double longest = (bounds.high - bounds.low).maxCoeff();
  const double scale = longest > 0.0 ? 0x1fffff / longest : 0.0;
  std::vector<std::pair<std::uint64_t, Index>> codes(static_cast<std::size_t>(positions.rows()));
  for (std::size_t v = 0; v < codes.size(); ++v) {
    const Vec3 cell = scale * (positions.row(static_cast<Eigen::Index>(v)).transpose() - bounds.low);
    const auto at = [&](int axis) { return spread(static_cast<std::uint64_t>(cell[axis])) << axis; };
    codes[v] = {at(0) | at(1) | at(2), static_cast<Index>(v)};
  }
  std::sort(codes.begin(), codes.end());
  std::vector<Index> order(codes.size());
  std::transform(codes.begin(), codes.end(), order.begin(), [](const auto& code) { return code.second; });
  return order;
}

}  // namespace

struct RestMesh::Derived {
  Lazy<Triangles> triangles;
  Lazy<Points> normals;
  Lazy<Topology> topology;
  Lazy<SurfaceGraph> graph;
  Lazy<NearestPoints> nearest;
  Lazy<std::vector<Index>> order;
};

RestMesh::RestMesh(Mesh mesh)
    : mesh_(std::move(mesh)), bounds_(boundsOf(mesh_.positions)), derived_(std::make_unique<Derived>()) {}
RestMesh::~RestMesh() = default;

const Triangles& RestMesh::triangles() const {
  return derived_->triangles.get([&] { return triangulate(mesh_.positions, mesh_.faces); });
}

const Points& RestMesh::normals() const {
  return derived_->normals.get([&] { return vertexNormals(mesh_.positions, triangles()); });
}

const Topology& RestMesh::topology() const {
  return derived_->topology.get([&] { return topologyOf(mesh_); });
}

const SurfaceGraph& RestMesh::graph() const {
  return derived_->graph.get([&] { return SurfaceGraph(mesh_); });
}

const NearestPoints& RestMesh::nearestVertex() const {
  return derived_->nearest.get([&] { return NearestPoints(mesh_.positions); });
}

const std::vector<Index>& RestMesh::mortonOrder() const {
  return derived_->order.get([&] { return mortonOrderOf(mesh_.positions, bounds_); });
}

}  // namespace pbffd
