#include "core/mesh/io/carried.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/numbers.h"

#include <cmath>
#include <span>

namespace pbffd::io {
namespace {

/// What a vertex of an OFF file holds behind its position.
struct OffColumns {
  std::optional<Attribute> normals;
  std::optional<Attribute> colors;
  std::optional<Attribute> texture;
};

std::optional<Attribute> columnOf(const Mesh& mesh, const std::optional<Attribute>& attribute) {
  return attribute ? perVertex(mesh, *attribute) : std::nullopt;
}

/// Colours as whole numbers from 0 to 255 where they are such; else from 0 to 1.
std::optional<Attribute> offColors(const Mesh& mesh, AttributeDomain domain) {
  auto colors = colorsOf(mesh, domain);
  if (colors && areBytes(*colors)) {
    for (double& value : colors->values) {
      value = std::round(255.0 * value);
    }
  }
  return colors;
}

OffColumns columnsOf(const Reshaped& shape) {
  OffColumns columns{columnOf(shape.mesh(), normalsOf(shape.mesh())),
                     offColors(shape.mesh(), AttributeDomain::vertex),
                     columnOf(shape.mesh(), textureCoordinatesOf(shape.mesh()))};
  if (columns.normals) {
    const Points turned = shape.turned(*columns.normals).values;
    columns.normals->values.assign(turned.data(), turned.data() + turned.size());
  }
  if (columns.texture && columns.texture->width != 2) {
    columns.texture.reset();
  }
  return columns;
}

void appendRow(std::string& text, const std::optional<Attribute>& attribute, Index row) {
  if (!attribute) {
    return;
  }
  const auto width = static_cast<std::size_t>(attribute->width);
  for (const double value :
       std::span(attribute->values).subspan(static_cast<std::size_t>(row) * width, width)) {
    text += ' ';
    appendNumber(text, value);
  }
}

}  // namespace

std::string writeOff(const Reshaped& shape) {
  const Mesh& mesh = shape.mesh();
  const OffColumns columns = columnsOf(shape);
  const auto faceColors = offColors(mesh, AttributeDomain::face);
  std::string text = columns.texture ? "ST" : "";
  text += columns.colors ? "C" : "";
  text += columns.normals ? "N" : "";
  text += "OFF\n";
  appendInteger(text, mesh.vertexCount());
  text += ' ';
  appendInteger(text, mesh.faces.size());
  text += " 0\n";
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      text += axis == 0 ? "" : " ";
      appendNumber(text, shape.positions()(v, axis));
    }
    appendRow(text, columns.normals, v);
    appendRow(text, columns.colors, v);
    appendRow(text, columns.texture, v);
    text += '\n';
  }
  shape.checkpoint(1, 2);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    appendInteger(text, static_cast<std::int64_t>(mesh.faces[f].size()));
    for (const Index vertex : mesh.faces[f]) {
      text += ' ';
      appendInteger(text, vertex);
    }
    appendRow(text, faceColors, f);
    text += '\n';
  }
  return text;
}

}  // namespace pbffd::io
