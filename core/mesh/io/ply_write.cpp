#include "core/base/text.h"
#include "core/mesh/io/carried.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/ply_body.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace pbffd::io {
namespace {

/// Colours of the vertices or the faces, and the type that holds them.
struct ColorColumns {
  explicit ColorColumns(std::optional<Attribute> found) : colors(std::move(found)) {
    isByte = colors && areBytes(*colors);
  }
  std::optional<Attribute> colors;
  bool isByte = false;
};

class PlyWriter {
 public:
  explicit PlyWriter(const Reshaped& shape);
  std::string write();

 private:
  void writeHeader();
  void writeVertex(Index vertex);
  void writeFace(Index face);
  void add(double value, PlyType type) { text_ += encodePlyNumber(value, type, PlyEncoding::littleEndian); }
  void writeTexture(Index face);
  void addRow(const Attribute& attribute, Index row, PlyType type, double scale = 1.0);
  void addColor(const ColorColumns& columns, Index row);
  void declareColor(const ColorColumns& columns);

  const Reshaped& shape_;
  const Mesh& mesh_;
  std::optional<Attribute> normals_;
  ColorColumns vertexColors_;
  ColorColumns faceColors_;
  std::optional<Attribute> texture_;
  PlyType countType_ = PlyType::uint8;
  std::string text_;
};

PlyWriter::PlyWriter(const Reshaped& shape)
    : shape_(shape),
      mesh_(shape.mesh()),
      vertexColors_(colorsOf(mesh_, AttributeDomain::vertex)),
      faceColors_(colorsOf(mesh_, AttributeDomain::face)),
      texture_(textureCoordinatesOf(mesh_)) {
  if (const auto normals = normalsOf(mesh_)) {
    normals_ = perVertex(mesh_, *normals);
  }
  if (normals_) {
    const Points turned = shape.turned(*normals_).values;
    normals_->values.assign(turned.data(), turned.data() + turned.size());
  }
  for (Index f = 0; f < mesh_.faces.size(); ++f) {
    // Two texture coordinates for each corner go into a list as well.
    if (2 * mesh_.faces[f].size() > std::numeric_limits<std::uint8_t>::max()) {
      countType_ = PlyType::int32;
    }
  }
}

std::string PlyWriter::write() {
  writeHeader();
  for (Index v = 0; v < mesh_.vertexCount(); ++v) {
    writeVertex(v);
  }
  shape_.checkpoint(1, 2);
  for (Index f = 0; f < mesh_.faces.size(); ++f) {
    writeFace(f);
  }
  return std::move(text_);
}

void PlyWriter::declareColor(const ColorColumns& columns) {
  if (!columns.colors) {
    return;
  }
  const std::string_view type = columns.isByte ? "uchar" : "float";
  for (const std::string_view name : {"red", "green", "blue", "alpha"}) {
    if (name != "alpha" || columns.colors->width == 4) {
      text_ += format("property {} {}\n", type, name);
    }
  }
}

void PlyWriter::writeHeader() {
  text_ += format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", mesh_.vertexCount());
  text_ += "property double x\nproperty double y\nproperty double z\n";
  if (normals_) {
    text_ += "property double nx\nproperty double ny\nproperty double nz\n";
  }
  declareColor(vertexColors_);
  const std::string_view count = countType_ == PlyType::uint8 ? "uchar" : "int";
  text_ += format("element face {}\nproperty list {} int vertex_indices\n", mesh_.faces.size(), count);
  declareColor(faceColors_);
  if (texture_) {
    text_ += format("property list {} double texcoord\n", count);
  }
  text_ += "end_header\n";
}

void PlyWriter::addRow(const Attribute& attribute, Index row, PlyType type, double scale) {
  const auto width = static_cast<std::size_t>(attribute.width);
  for (std::size_t i = 0; i < width; ++i) {
    add(scale * attribute.values[static_cast<std::size_t>(row) * width + i], type);
  }
}

void PlyWriter::addColor(const ColorColumns& columns, Index row) {
  if (columns.colors) {
    addRow(*columns.colors, row, columns.isByte ? PlyType::uint8 : PlyType::float32,
           columns.isByte ? 255.0 : 1.0);
  }
}

void PlyWriter::writeVertex(Index vertex) {
  for (int axis = 0; axis < 3; ++axis) {
    add(shape_.positions()(vertex, axis), PlyType::float64);
  }
  if (normals_) {
    addRow(*normals_, vertex, PlyType::float64);
  }
  addColor(vertexColors_, vertex);
}

void PlyWriter::writeFace(Index face) {
  const std::span<const Index> corners = mesh_.faces[face];
  add(static_cast<double>(corners.size()), countType_);
  for (const Index vertex : corners) {
    add(vertex, PlyType::int32);
  }
  addColor(faceColors_, face);
  if (texture_) {
    writeTexture(face);
  }
}

/// A list of two numbers for each corner; an empty one where a corner has none.
void PlyWriter::writeTexture(Index face) {
  const std::span<const Index> corners = mesh_.faces[face];
  const auto first = static_cast<std::size_t>(mesh_.faces.offsets()[static_cast<std::size_t>(face)]);
  std::vector<Index> rows;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    rows.push_back(texture_->domain == AttributeDomain::vertex ? corners[i] : texture_->rowOfCorner[first + i]);
  }
  if (std::ranges::any_of(rows, [](Index row) { return row < 0; })) {
    rows.clear();
  }
  add(static_cast<double>(2 * rows.size()), countType_);
  const auto width = static_cast<std::size_t>(texture_->width);
  for (const Index row : rows) {
    const std::size_t at = static_cast<std::size_t>(row) * width;
    add(texture_->values[at], PlyType::float64);
    add(width > 1 ? texture_->values[at + 1] : 0.0, PlyType::float64);
  }
}

}  // namespace

std::string writePly(const Reshaped& shape) {
  return PlyWriter(shape).write();
}

}  // namespace pbffd::io
