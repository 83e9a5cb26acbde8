#include "core/mesh/io/carried.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/obj_statements.h"
#include "core/mesh/io/patch.h"
#include "core/mesh/io/text_scanner.h"

namespace pbffd::io {
namespace {

/// The normals (vn) as the deformation turns them; none where the file has none.
TurnedNormals turnedNormals(const Reshaped& shape) {
  const auto normals = normalsOf(shape.mesh());
  return normals ? shape.turned(*normals) : TurnedNormals();
}

/// Goes over an OBJ file and replaces the numbers of what moved.
class ObjRewriter {
 public:
  ObjRewriter(const Reshaped& shape, const Input& input)
      : shape_(shape), normals_(turnedNormals(shape)), patch_(input.bytes), scanner_(input, objSyntax) {}

  std::string rewrite();

 private:
  void rewriteVertex();
  void rewriteNormal();

  const Reshaped& shape_;
  TurnedNormals normals_;
  Patch patch_;
  TextScanner scanner_;
  Index vertex_ = 0;
  Index normal_ = 0;
};

std::string ObjRewriter::rewrite() {
  std::size_t statements = 0;
  for (std::string_view word = scanner_.wordAnywhere(); !word.empty(); word = scanner_.firstWordOfNextLine()) {
    if (word == "v") {
      rewriteVertex();
    } else if (word == "vn") {
      rewriteNormal();
    }
    if (++statements % stepsToCheckpoint == 0) {
      shape_.checkpoint(scanner_.byte(), scanner_.input().bytes.size());
    }
  }
  return patch_.finish();
}

void ObjRewriter::rewriteVertex() {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view piece = scanner_.word();
    if (shape_.isMoved(vertex_, axis)) {
      patch_.replace(piece, shape_.positions()(vertex_, axis));
    }
  }
  ++vertex_;
}

void ObjRewriter::rewriteNormal() {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view piece = scanner_.word();
    if (normals_.isChanged(normal_, axis)) {
      patch_.replace(piece, normals_.values(normal_, axis));
    }
  }
  ++normal_;
}

}  // namespace

std::string rewriteObj(const Reshaped& shape) {
  const Input input = shape.source();
  return ObjRewriter(shape, input).rewrite();
}

}  // namespace pbffd::io
