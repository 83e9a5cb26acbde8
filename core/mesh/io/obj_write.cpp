#include "core/mesh/io/carried.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/numbers.h"

#include <span>

namespace pbffd::io {
namespace {

void appendNumbers(std::string& text, std::span<const double> numbers) {
  for (const double number : numbers) {
    text += ' ';
    appendNumber(text, number);
  }
}

/// Lines of `keyword` and the numbers of a row each.
void appendRows(std::string& text, std::string_view keyword, const std::vector<double>& values,
                std::size_t width) {
  for (std::size_t at = 0; at < values.size(); at += width) {
    text += keyword;
    appendNumbers(text, std::span(values).subspan(at, width));
    text += '\n';
  }
}

/// The row of an attribute that a corner uses, -1 for none.
Index rowAt(const std::optional<Attribute>& attribute, std::size_t corner, Index vertex) {
  if (!attribute) {
    return -1;
  }
  return attribute->domain == AttributeDomain::vertex ? vertex : attribute->rowOfCorner[corner];
}

class ObjWriter {
 public:
  explicit ObjWriter(const Reshaped& shape)
      : shape_(shape), texture_(textureCoordinatesOf(shape.mesh())), normals_(normalsOf(shape.mesh())) {}

  std::string write();

 private:
  void writeVertices();
  void writeFace(Index face);

  const Reshaped& shape_;
  std::optional<Attribute> texture_;
  std::optional<Attribute> normals_;
  std::string text_;
};

std::string ObjWriter::write() {
  writeVertices();
  if (texture_) {
    appendRows(text_, "vt", texture_->values, static_cast<std::size_t>(texture_->width));
  }
  if (normals_) {
    const Points turned = shape_.turned(*normals_).values;
    appendRows(text_, "vn", std::vector<double>(turned.data(), turned.data() + turned.size()), 3);
  }
  const Index faces = shape_.mesh().faces.size();
  for (Index face = 0; face < faces; ++face) {
    writeFace(face);
    if (static_cast<std::size_t>(face) % stepsToCheckpoint == 0) {
      shape_.checkpoint(static_cast<std::size_t>(face), static_cast<std::size_t>(faces));
    }
  }
  return std::move(text_);
}

void ObjWriter::writeVertices() {
  const auto colors = colorsOf(shape_.mesh(), AttributeDomain::vertex);
  for (Index v = 0; v < shape_.mesh().vertexCount(); ++v) {
    text_ += 'v';
    appendNumbers(text_, std::span(shape_.positions().row(v).data(), 3));
    if (colors) {
      const auto width = static_cast<std::size_t>(colors->width);
      appendNumbers(text_, std::span(colors->values).subspan(static_cast<std::size_t>(v) * width, 3));
    }
    text_ += '\n';
  }
}

/// OBJ has words of its own for faces of one and two corners: points and lines.
void ObjWriter::writeFace(Index face) {
  const std::span<const Index> corners = shape_.mesh().faces[face];
  if (corners.empty()) {
    return;
  }
  text_ += corners.size() == 1 ? 'p' : corners.size() == 2 ? 'l' : 'f';
  const auto first = static_cast<std::size_t>(shape_.mesh().faces.offsets()[static_cast<std::size_t>(face)]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    text_ += ' ';
    appendInteger(text_, corners[i] + std::int64_t{1});
    if (corners.size() < 3) {
      continue;
    }
    const Index texture = rowAt(texture_, first + i, corners[i]);
    const Index normal = rowAt(normals_, first + i, corners[i]);
    if (texture >= 0 || normal >= 0) {
      text_ += '/';
    }
    if (texture >= 0) {
      appendInteger(text_, texture + std::int64_t{1});
    }
    if (normal >= 0) {
      text_ += '/';
      appendInteger(text_, normal + std::int64_t{1});
    }
  }
  text_ += '\n';
}

}  // namespace

std::string writeObj(const Reshaped& shape) {
  return ObjWriter(shape).write();
}

}  // namespace pbffd::io
