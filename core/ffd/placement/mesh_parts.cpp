#include "core/ffd/placement/mesh_parts.h"

#include "core/ffd/placement/random_order.h"

#include <algorithm>
#include <cstdint>

namespace pbffd {
namespace {

/// The vertices that stand for those at the same position, or for themselves.
class Corners {
 public:
  Corners(const RestMesh& mesh, bool joinsSeams) : graph_(joinsSeams ? &mesh.graph() : nullptr) {}
  Index operator()(Index vertex) const { return graph_ != nullptr ? graph_->representative(vertex) : vertex; }

 private:
  const SurfaceGraph* graph_;
};

bool hasSeams(const RestMesh& mesh) {
  const std::vector<Index>& vertices = mesh.mesh().faces.vertices();
  return std::any_of(vertices.begin(), vertices.end(),
                     [&](Index vertex) { return mesh.graph().representative(vertex) != vertex; });
}

/// The faces of components with a border, between vertices of which each position has one.
Mesh borderedWithoutSeams(const RestMesh& mesh) {
  const Topology& topology = mesh.topology();
  const Polygons& faces = mesh.mesh().faces;
  Mesh joined;
  joined.positions = mesh.positions();
  std::vector<Index> corners;
  for (Index f = 0; f < faces.size(); ++f) {
    if (const Index part = topology.componentOfFace[f]; part >= 0 && !topology.isComponentClosed[part]) {
      corners.assign(faces[f].begin(), faces[f].end());
      std::transform(corners.begin(), corners.end(), corners.begin(), Corners(mesh, true));
      joined.faces.add(corners);
    }
  }
  return joined;
}

/// The closed components as they are, then those of the rest after joining.
MeshParts joinedAlongSeams(const RestMesh& mesh) {
  const Topology& before = mesh.topology();
  const Topology rest = topologyOf(borderedWithoutSeams(mesh));
  MeshParts joined;
  std::vector<Index> number(before.isComponentClosed.size(), -1);
  for (std::size_t part = 0; part < number.size(); ++part) {
    if (before.isComponentClosed[part]) {
      number[part] = static_cast<Index>(joined.isClosed.size());
      joined.isClosed.push_back(true);
    }
  }
  const auto closed = static_cast<Index>(joined.isClosed.size());
  joined.isClosed.insert(joined.isClosed.end(), rest.isComponentClosed.begin(), rest.isComponentClosed.end());
  std::size_t next = 0;
  for (const Index part : before.componentOfFace) {
    joined.ofFace.push_back(part < 0            ? -1
                            : number[part] >= 0 ? number[part]
                                                : closed + rest.componentOfFace[next++]);
  }
  return joined;
}

/// Of a part without a border each edge is passed by two faces. Where these agree on which side is out they
/// pass it in opposite directions, so numbers that change their sign with the direction add up to zero; else
/// they hardly ever do.
std::vector<bool> consistentFlags(const RestMesh& mesh, const MeshParts& parts, const Corners& cornerOf) {
  const auto directed = [](Index from, Index to) {
    const auto low = static_cast<std::uint64_t>(std::min(from, to));
    const auto high = static_cast<std::uint64_t>(std::max(from, to));
    const std::uint64_t number = scrambled(high << 32 | low);
    return from < to ? number : -number;
  };
  const Polygons& faces = mesh.mesh().faces;
  std::vector<std::uint64_t> sums(parts.isClosed.size(), 0);
  for (Index f = 0; f < faces.size(); ++f) {
    const auto face = faces[f];
    for (std::size_t c = 0; c < face.size(); ++c) {
      const Index from = cornerOf(face[c]);
      const Index to = cornerOf(face[c + 1 < face.size() ? c + 1 : 0]);
      sums[parts.ofFace[f]] += from != to ? directed(from, to) : 0;
    }
  }
  std::vector<bool> isConsistent;
  std::transform(sums.begin(), sums.end(), std::back_inserter(isConsistent),
                 [](std::uint64_t sum) { return sum == 0; });
  return isConsistent;
}

}  // namespace

MeshParts meshParts(const RestMesh& mesh) {
  const Topology& topology = mesh.topology();
  const std::vector<bool>& isClosed = topology.isComponentClosed;
  const bool hasBorder = std::find(isClosed.begin(), isClosed.end(), false) != isClosed.end();
  const bool joinsSeams = hasBorder && hasSeams(mesh);
  MeshParts parts = joinsSeams ? joinedAlongSeams(mesh) : MeshParts{topology.componentOfFace, isClosed, 0};
  const std::vector<bool> isConsistent = consistentFlags(mesh, parts, Corners(mesh, joinsSeams));
  for (std::size_t part = 0; part < parts.isClosed.size(); ++part) {
    if (parts.isClosed[part] && !isConsistent[part]) {
      parts.isClosed[part] = false;
      ++parts.inconsistentCount;
    }
  }
  return parts;
}

}  // namespace pbffd
