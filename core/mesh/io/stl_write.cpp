#include "core/mesh/io/formats.h"
#include "core/mesh/io/stl_binary.h"
#include "core/mesh/io/stl_shape.h"

namespace pbffd::io {
namespace {

std::string header(std::size_t facets) {
  // Not "solid", which begins a text file.
  std::string bytes = "Binary STL of PB-FFD Workbench";
  bytes.resize(stlHeaderBytes - 4, ' ');
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((facets >> shift) & 0xFF);
  }
  return bytes;
}

}  // namespace

std::string writeStl(const Reshaped& shape) {
  const Triangles triangles = triangulate(shape.positions(), shape.mesh().faces);
  if (triangles.size() == 0) {
    shape.fail("It has no faces, and an STL file holds nothing else", "Export to OBJ, OFF or PLY.");
  }
  const auto facets = static_cast<std::size_t>(triangles.size());
  std::string bytes = header(facets);
  bytes.reserve(stlHeaderBytes + stlFacetBytes * facets);
  for (std::size_t facet = 0; facet < facets; ++facet) {
    const Index* corner = triangles.vertices().data() + 3 * facet;
    const Vec3 a = stlPosition(shape, corner[0]);
    const Vec3 b = stlPosition(shape, corner[1]);
    const Vec3 c = stlPosition(shape, corner[2]);
    for (const Vec3& vector : {facetNormal(a, b, c), a, b, c}) {
      bytes += encodeStlVector(vector);
    }
    bytes.append(2, '\0');
    if (facet % stepsToCheckpoint == 0) {
      shape.checkpoint(facet, facets);
    }
  }
  return bytes;
}

}  // namespace pbffd::io
