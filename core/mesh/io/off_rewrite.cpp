#include "core/mesh/io/carried.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/off_scanner.h"
#include "core/mesh/io/patch.h"

namespace pbffd::io {

std::string rewriteOff(const Reshaped& shape) {
  const Input input = shape.source();
  OffScanner scanner(input);
  const auto normals = normalsOf(shape.mesh());
  const TurnedNormals turned = normals ? shape.turned(*normals) : TurnedNormals();
  Patch patch(input.bytes);
  for (Index v = 0; v < shape.mesh().vertexCount(); ++v) {
    const OffVertex vertex = scanner.nextVertex();
    for (int axis = 0; axis < 3; ++axis) {
      if (shape.isMoved(v, axis)) {
        patch.replace(vertex.position[static_cast<std::size_t>(axis)], shape.positions()(v, axis));
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (turned.isChanged(v, axis)) {
        patch.replace(vertex.normal[static_cast<std::size_t>(axis)], turned.values(v, axis));
      }
    }
    while (!scanner.text().word().empty()) {
    }
    if (static_cast<std::size_t>(v) % stepsToCheckpoint == 0) {
      shape.checkpoint(scanner.text().byte(), input.bytes.size());
    }
  }
  return patch.finish();
}

}  // namespace pbffd::io
