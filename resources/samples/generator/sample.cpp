#include "resources/samples/generator/sample.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mesh/topology.h"

#include <iterator>

namespace pbffd::samples {
namespace {

/// 0.0 for what would be printed as "-0.0".
double unsignedZero(double value) {
  return std::abs(value) < 5e-7 ? 0.0 : value;
}

void appendFace(std::string& text, const Sample& sample, Index face) {
  const Index first = sample.faces.offsets()[face];
  text += 'f';
  for (Index corner = first; corner < sample.faces.offsets()[face + 1]; ++corner) {
    text += format(" {}/{}/{}", sample.faces.vertices()[corner] + 1, sample.textureOfCorner[corner] + 1,
                   sample.normalOfCorner[corner] + 1);
  }
  text += '\n';
}

/// The faces around each vertex must form a single fan: as many edges as faces, or one more on a boundary.
bool hasSingleFans(const Sample& sample) {
  std::vector<std::vector<std::pair<Index, Index>>> around(sample.positions.rows());
  for (Index f = 0; f < sample.faces.size(); ++f) {
    const auto corners = sample.faces[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t last = corners.size() - 1;
      around[corners[i]].emplace_back(corners[i == 0 ? last : i - 1], corners[i == last ? 0 : i + 1]);
    }
  }
  for (const auto& wedges : around) {
    // Walks from wedge to wedge over shared edges; a single fan leaves none out.
    std::vector<Index> reached{0};
    std::vector<bool> isReached(wedges.size(), false);
    for (std::size_t next = 0; next < reached.size() && !wedges.empty(); ++next) {
      isReached[0] = true;
      for (Index w = 0; w < static_cast<Index>(wedges.size()); ++w) {
        const auto& from = wedges[reached[next]];
        if (!isReached[w] && (wedges[w].first == from.second || wedges[w].second == from.first)) {
          isReached[w] = true;
          reached.push_back(w);
        }
      }
    }
    if (reached.size() != wedges.size()) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::string toObj(const Sample& sample) {
  std::string text =
      format("# {}\n# Made by the sample generator of PB-FFD Workbench.\no {}\n", sample.about, sample.name);
  for (const auto& position : sample.positions.rowwise()) {
    text += format("v {:.6f} {:.6f} {:.6f}\n", unsignedZero(position.x()), unsignedZero(position.y()),
                   unsignedZero(position.z()));
  }
  for (const auto& texture : sample.textures.rowwise()) {
    text += format("vt {:.6f} {:.6f}\n", unsignedZero(texture.x()), unsignedZero(texture.y()));
  }
  for (const auto& normal : sample.normals.rowwise()) {
    text += format("vn {:.6f} {:.6f} {:.6f}\n", unsignedZero(normal.x()), unsignedZero(normal.y()),
                   unsignedZero(normal.z()));
  }
  for (std::size_t group = 0; group < sample.groups.size(); ++group) {
    text += format("g {}\n", sample.groups[group]);
    for (Index f = 0; f < sample.faces.size(); ++f) {
      if (sample.groupOfFace[f] == static_cast<Index>(group)) {
        appendFace(text, sample, f);
      }
    }
  }
  return text;
}

void requireSound(const Sample& sample) {
  Mesh mesh;
  mesh.positions = sample.positions;
  mesh.faces = sample.faces;
  const Topology topology = topologyOf(mesh);
  const bool isSound = topology.components == 1 && topology.nonmanifoldEdges == 0 &&
                       topology.isolatedVertices == 0 && topology.isClosed == sample.isClosed &&
                       hasSingleFans(sample);
  if (!isSound) {
    throw InvalidInput(
        format("The sample {} is not sound: {} components, {} non-manifold and {} boundary edges, {} isolated "
               "vertices, single fans: {}.",
               sample.name, topology.components, topology.nonmanifoldEdges, topology.boundaryEdges,
               topology.isolatedVertices, hasSingleFans(sample)));
  }
}

}  // namespace pbffd::samples
