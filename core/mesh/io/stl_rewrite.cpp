#include "core/base/text.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/patch.h"
#include "core/mesh/io/stl_binary.h"
#include "core/mesh/io/stl_shape.h"
#include "core/mesh/io/stl_text.h"

namespace pbffd::io {
namespace {

std::string rewriteText(const Reshaped& shape, const Input& input) {
  Patch patch(input.bytes);
  StlText scanner(input);
  const Polygons& faces = shape.mesh().faces;
  for (Index face = 0; scanner.next() && face < faces.size(); ++face) {
    if (const auto normal = movedFacetNormal(shape, face)) {
      for (int axis = 0; axis < 3; ++axis) {
        patch.replace(scanner.facet().normal[static_cast<std::size_t>(axis)], (*normal)[axis]);
      }
    }
    for (std::size_t corner = 0; corner < faces[face].size(); ++corner) {
      const Index vertex = faces[face][corner];
      for (int axis = 0; axis < 3; ++axis) {
        if (shape.isMoved(vertex, axis)) {
          patch.replace(scanner.facet().corners[corner][static_cast<std::size_t>(axis)],
                        shape.positions()(vertex, axis));
        }
      }
    }
    if (static_cast<std::size_t>(face) % stepsToCheckpoint == 0) {
      shape.checkpoint(scanner.text().byte(), input.bytes.size());
    }
  }
  return patch.finish();
}

std::string rewriteBinary(const Reshaped& shape, const Input& input) {
  Patch patch(input.bytes);
  const Polygons& faces = shape.mesh().faces;
  for (Index face = 0; face < faces.size(); ++face) {
    const auto facet = static_cast<std::size_t>(face);
    if (const auto normal = movedFacetNormal(shape, face)) {
      patch.replace(stlVector(input.bytes, facet, 0), encodeStlVector(*normal));
    }
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Index vertex = faces[face][corner];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (shape.isMoved(vertex, static_cast<int>(axis))) {
          const std::string position = encodeStlVector(stlPosition(shape, vertex));
          patch.replace(stlVector(input.bytes, facet, 1 + corner).substr(4 * axis, 4),
                        std::string_view(position).substr(4 * axis, 4));
        }
      }
    }
    if (facet % stepsToCheckpoint == 0) {
      shape.checkpoint(facet, static_cast<std::size_t>(faces.size()));
    }
  }
  return patch.finish();
}

}  // namespace

std::string rewriteStl(const Reshaped& shape) {
  const Input input = shape.source();
  return isBinaryStl(input.bytes) ? rewriteBinary(shape, input) : rewriteText(shape, input);
}

}  // namespace pbffd::io
