#include "core/base/text.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/stl_binary.h"
#include "core/mesh/io/stl_text.h"
#include "core/mesh/io/vertex_welder.h"

#include <array>
#include <limits>
#include <utility>

namespace pbffd::io {
namespace {

/// What both kinds of STL come to.
struct StlMesh {
  VertexWelder vertices;
  Mesh mesh;
  std::vector<double> normals;
  std::vector<double> attributes;  ///< empty where all are zero

  Mesh finish() {
    mesh.positions = vertices.points();
    mesh.attributes.push_back({"normal", AttributeDomain::face, 3, std::move(normals), {}});
    if (!attributes.empty()) {
      mesh.attributes.push_back({"attribute", AttributeDomain::face, 1, std::move(attributes), {}});
    }
    return std::move(mesh);
  }
};

Mesh readText(const Input& input) {
  StlMesh stl;
  StlText scanner(input);
  const TextScanner& text = scanner.text();
  std::vector<Index> corners;
  for (std::size_t facet = 0; scanner.next(); ++facet) {
    for (const std::string_view word : scanner.facet().normal) {
      stl.normals.push_back(text.number(word, "a coordinate of a normal"));
    }
    corners.clear();
    for (const auto& corner : scanner.facet().corners) {
      Vec3 point;
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] = text.coordinate(corner[static_cast<std::size_t>(axis)], "a coordinate of a vertex");
      }
      corners.push_back(stl.vertices.add(point));
    }
    stl.mesh.faces.add(corners);
    if (facet % stepsToCheckpoint == 0) {
      input.checkpoint(text.byte());
    }
  }
  return stl.finish();
}

void checkSize(const Input& input) {
  if (input.bytes.size() < stlHeaderBytes) {
    input.failAtByte(input.bytes.size(),
                     "the file ends within its header, which has 84 bytes in a binary STL file", adviceCutOff);
  }
  const std::size_t promised = stlFacetCount(input.bytes);
  const std::size_t held = (input.bytes.size() - stlHeaderBytes) / stlFacetBytes;
  if (promised > held) {
    input.failAtByte(80, format("the header promises {} facets, but the file has room for {}", promised, held),
                     adviceCutOff);
  }
  if (promised > static_cast<std::size_t>(std::numeric_limits<Index>::max()) / 3) {
    input.failAtByte(80, "the file has more facets than can be numbered", "Split the mesh.");
  }
}

/// The two bytes of each facet; nothing where all are zero.
std::vector<double> readAttributes(const Input& input) {
  std::vector<double> values(stlFacetCount(input.bytes));
  bool isUsed = false;
  for (std::size_t facet = 0; facet < values.size(); ++facet) {
    values[facet] = stlAttribute(input.bytes, facet);
    isUsed = isUsed || values[facet] != 0.0;
  }
  return isUsed ? values : std::vector<double>();
}

Mesh readBinary(const Input& input) {
  checkSize(input);
  StlMesh stl;
  const std::size_t facets = stlFacetCount(input.bytes);
  stl.mesh.faces.reserve(facets, 3 * facets);
  for (std::size_t facet = 0; facet < facets; ++facet) {
    const Vec3 normal = decodeStlVector(stlVector(input.bytes, facet, 0));
    stl.normals.insert(stl.normals.end(), {normal[0], normal[1], normal[2]});
    std::array<Index, 3> corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::string_view piece = stlVector(input.bytes, facet, 1 + i);
      const Vec3 point = decodeStlVector(piece);
      if (!point.allFinite()) {
        input.failAtByte(static_cast<std::size_t>(piece.data() - input.bytes.data()),
                         format("vertex {} of facet {} has a coordinate that is not a finite number", i, facet),
                         adviceCorrect);
      }
      corners[i] = stl.vertices.add(point);
    }
    stl.mesh.faces.add(corners);
    if (facet % stepsToCheckpoint == 0) {
      input.checkpoint(stlHeaderBytes + stlFacetBytes * facet);
    }
  }
  stl.attributes = readAttributes(input);
  if (const std::size_t rest = input.bytes.size() - stlHeaderBytes - stlFacetBytes * facets; rest > 0) {
    stl.mesh.remarks.push_back(
        format("The last {} behind the facets are kept by an STL export.", counted(rest, "byte", "bytes")));
  }
  return stl.finish();
}

}  // namespace

Mesh readStl(const Input& input) {
  return isBinaryStl(input.bytes) ? readBinary(input) : readText(input);
}

}  // namespace pbffd::io
