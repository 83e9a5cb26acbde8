#include "core/base/text.h"
#include "core/mesh/io/carried.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/patch.h"
#include "core/mesh/io/ply_body.h"

#include <array>
#include <cmath>

namespace pbffd::io {
namespace {

enum class Role { position, normal, other };

/// What a property of the vertices is, and which axis of it.
struct Column {
  Role role = Role::other;
  int axis = 0;
};

std::vector<Column> columnsOf(const PlyElement& vertices) {
  constexpr std::array<std::string_view, 3> positions{"x", "y", "z"};
  constexpr std::array<std::string_view, 3> normals{"nx", "ny", "nz"};
  std::vector<Column> columns(vertices.properties.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (const auto found = vertices.find(positions[axis])) {
      columns[*found] = {Role::position, static_cast<int>(axis)};
    }
    if (const auto found = vertices.find(normals[axis])) {
      columns[*found] = {Role::normal, static_cast<int>(axis)};
    }
  }
  return columns;
}

class PlyRewriter {
 public:
  PlyRewriter(const Reshaped& shape, const Input& input)
      : shape_(shape), header_(parsePlyHeader(input)), body_(input, header_), patch_(input.bytes) {
    if (const auto normals = normalsOf(shape.mesh())) {
      normals_ = shape.turned(*normals);
    }
  }

  std::string rewrite();

 private:
  void rewriteVertices(const PlyElement& vertices);
  void rewriteNumber(const PlyProperty& property, Column column, Index vertex);
  void checkPosition(double value, const PlyProperty& property) const;

  const Reshaped& shape_;
  PlyHeader header_;
  PlyBody body_;
  Patch patch_;
  TurnedNormals normals_;
};

std::string PlyRewriter::rewrite() {
  for (const PlyElement& element : header_.elements) {
    if (element.name == "vertex") {
      rewriteVertices(element);
      break;
    }
    for (std::size_t row = 0; row < element.count && !element.properties.empty(); ++row) {
      for (const PlyProperty& property : element.properties) {
        body_.skip(property);
      }
    }
  }
  return patch_.finish();
}

void PlyRewriter::rewriteVertices(const PlyElement& vertices) {
  const std::vector<Column> columns = columnsOf(vertices);
  for (Index v = 0; v < shape_.mesh().vertexCount(); ++v) {
    for (std::size_t p = 0; p < vertices.properties.size(); ++p) {
      const PlyProperty& property = vertices.properties[p];
      if (property.countType) {
        body_.skip(property);
      } else {
        rewriteNumber(property, columns[p], v);
      }
    }
    if (static_cast<std::size_t>(v) % stepsToCheckpoint == 0) {
      shape_.checkpoint(static_cast<std::size_t>(v), vertices.count);
    }
  }
}

void PlyRewriter::rewriteNumber(const PlyProperty& property, Column column, Index vertex) {
  body_.number(property.type);
  if (column.role == Role::position && shape_.isMoved(vertex, column.axis)) {
    const double value = shape_.positions()(vertex, column.axis);
    checkPosition(value, property);
    patch_.replace(body_.last(), encodePlyNumber(value, property.type, header_.encoding));
  } else if (column.role == Role::normal && normals_.isChanged(vertex, column.axis)) {
    const double value = normals_.values(vertex, column.axis);
    patch_.replace(body_.last(), encodePlyNumber(value, property.type, header_.encoding));
  }
}

void PlyRewriter::checkPosition(double value, const PlyProperty& property) const {
  constexpr std::string_view advice = "Export to OBJ, or to another file format.";
  const double held = heldValue(value, property.type);
  if (isInteger(property.type) && held != value) {
    shape_.fail(format("The file holds {} in whole numbers, which cannot hold the deformed shape",
                       inQuotes(property.name)),
                advice);
  }
  if (!std::isfinite(held)) {
    shape_.fail(format("{} is too large for the type of {} in the file", value, inQuotes(property.name)),
                advice);
  }
}

}  // namespace

std::string rewritePly(const Reshaped& shape) {
  const Input input = shape.source();
  return PlyRewriter(shape, input).rewrite();
}

}  // namespace pbffd::io
