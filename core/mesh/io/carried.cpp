#include "core/mesh/io/carried.h"

#include "core/mesh/io/ply_body.h"
#include "core/mesh/io/ply_header.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

namespace pbffd::io {
namespace {

const Attribute* find(const Mesh& mesh, std::string_view name, AttributeDomain domain) {
  const auto found = std::find_if(mesh.attributes.begin(), mesh.attributes.end(), [&](const Attribute& one) {
    return one.domain == domain && one.name == name;
  });
  return found == mesh.attributes.end() ? nullptr : &*found;
}

/// Single columns ("nx", "ny", "nz") side by side; nothing where one is missing.
std::optional<Attribute> joined(const Mesh& mesh, AttributeDomain domain,
                                std::initializer_list<std::string_view> names) {
  std::vector<const Attribute*> columns;
  std::size_t rows = 0;
  for (const std::string_view name : names) {
    const Attribute* column = find(mesh, name, domain);
    if (column == nullptr || column->width != 1) {
      return std::nullopt;
    }
    columns.push_back(column);
    rows = column->values.size();
  }
  Attribute result{"", domain, static_cast<Index>(columns.size()), {}, {}};
  result.values.reserve(rows * columns.size());
  for (std::size_t row = 0; row < rows; ++row) {
    for (const Attribute* column : columns) {
      result.values.push_back(column->values[row]);
    }
  }
  return result;
}

/// The first of the named attributes that the vertices or corners have.
std::optional<Attribute> firstOf(const Mesh& mesh, std::initializer_list<std::string_view> names) {
  for (const AttributeDomain domain : {AttributeDomain::corner, AttributeDomain::vertex}) {
    for (const std::string_view name : names) {
      if (const Attribute* attribute = find(mesh, name, domain)) {
        return *attribute;
      }
    }
  }
  return std::nullopt;
}

/// What full brightness is in these colours: a PLY file declares it by the type, all others write 1, 255 or
/// 65535.
double fullBrightness(const Mesh& mesh, const Attribute& colors) {
  if (mesh.source.format == MeshFormat::ply && mesh.source.bytes) {
    const PlyHeader header = parsePlyHeader({*mesh.source.bytes, mesh.source.name, Progress()});
    const PlyElement* element = header.find(colors.domain == AttributeDomain::face ? "face" : "vertex");
    const auto red = element == nullptr ? std::nullopt : element->find("red");
    if (red) {
      const PlyType type = element->properties[*red].type;
      return isInteger(type) ? heldValue(std::numeric_limits<double>::max(), type) : 1.0;
    }
  }
  const double largest = colors.values.empty() ? 0.0 : *std::ranges::max_element(colors.values);
  return largest <= 1.0 ? 1.0 : largest <= 255.0 ? 255.0 : 65535.0;
}

}  // namespace

std::optional<Attribute> normalsOf(const Mesh& mesh) {
  if (auto normals = firstOf(mesh, {"vn", "normal"}); normals && normals->width == 3) {
    return normals;
  }
  return joined(mesh, AttributeDomain::vertex, {"nx", "ny", "nz"});
}

std::optional<Attribute> textureCoordinatesOf(const Mesh& mesh) {
  if (auto found = firstOf(mesh, {"vt", "texture", "texcoord"}); found && found->width <= 3) {
    return found;
  }
  constexpr std::array<std::array<std::string_view, 2>, 4> pairs{
      {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}}};
  for (const auto& [first, second] : pairs) {
    if (auto found = joined(mesh, AttributeDomain::vertex, {first, second})) {
      return found;
    }
  }
  return std::nullopt;
}

std::optional<Attribute> colorsOf(const Mesh& mesh, AttributeDomain domain) {
  std::optional<Attribute> colors;
  if (const Attribute* found = find(mesh, "color", domain)) {
    colors = *found;
  } else if (auto withAlpha = joined(mesh, domain, {"red", "green", "blue", "alpha"})) {
    colors = std::move(withAlpha);
  } else {
    colors = joined(mesh, domain, {"red", "green", "blue"});
  }
  const auto isFinite = [](double x) { return std::isfinite(x); };
  if (!colors || colors->width < 3 || colors->width > 4 ||
      !std::all_of(colors->values.begin(), colors->values.end(), isFinite)) {
    return std::nullopt;
  }
  const double full = fullBrightness(mesh, *colors);
  for (double& value : colors->values) {
    value /= full;
  }
  return colors;
}

bool areBytes(const Attribute& colors) {
  // Six decimals of a multiple of 1/255 miss it by a thousandth of that at most.
  constexpr double tolerance = 1e-3;
  return std::ranges::all_of(colors.values, [](double value) {
    const double byte = 255.0 * value;
    return byte >= -tolerance && byte <= 255.0 + tolerance && std::abs(byte - std::round(byte)) <= tolerance;
  });
}

std::optional<Attribute> perVertex(const Mesh& mesh, const Attribute& attribute) {
  if (attribute.domain == AttributeDomain::vertex) {
    return attribute;
  }
  const auto width = static_cast<std::size_t>(attribute.width);
  const auto vertices = static_cast<std::size_t>(mesh.vertexCount());
  const auto row = [&](Index index) {
    return std::span(attribute.values).subspan(static_cast<std::size_t>(index) * width, width);
  };
  std::vector<Index> rowOfVertex(vertices, -1);
  for (std::size_t corner = 0; corner < attribute.rowOfCorner.size(); ++corner) {
    const Index named = attribute.rowOfCorner[corner];
    Index& known = rowOfVertex[static_cast<std::size_t>(mesh.faces.vertices()[corner])];
    if (named < 0 || (known >= 0 && known != named && !std::ranges::equal(row(known), row(named)))) {
      return std::nullopt;
    }
    known = named;
  }
  Attribute result{attribute.name, AttributeDomain::vertex, attribute.width, {}, {}};
  result.values.resize(vertices * width, 0.0);
  for (std::size_t v = 0; v < vertices; ++v) {
    if (rowOfVertex[v] >= 0) {
      std::ranges::copy(row(rowOfVertex[v]), result.values.begin() + static_cast<std::ptrdiff_t>(v * width));
    }
  }
  return result;
}

}  // namespace pbffd::io
