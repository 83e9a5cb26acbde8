#include "core/mesh/io/export_losses.h"

#include "core/base/text.h"
#include "core/mesh/io/carried.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace pbffd {
namespace {

std::string_view nameOf(MeshFormat format) {
  switch (format) {
    case MeshFormat::obj:
      return "OBJ";
    case MeshFormat::off:
      return "OFF";
    case MeshFormat::ply:
      return "PLY";
    default:
      return "STL";
  }
}

/// Whether normals or texture coordinates find a place in the format: STL has none, OBJ one for each corner,
/// the others one for each vertex; PLY holds texture coordinates of corners too.
bool holds(MeshFormat format, const Mesh& mesh, const Attribute& attribute, bool isTexture) {
  if (format == MeshFormat::stl || (isTexture && format == MeshFormat::off && attribute.width != 2)) {
    return false;
  }
  return format == MeshFormat::obj || (isTexture && format == MeshFormat::ply) ||
         io::perVertex(mesh, attribute).has_value();
}

/// Whether a line of an OBJ file begins with the keyword.
bool hasStatement(const Mesh& mesh, std::string_view keyword) {
  const std::string_view text = *mesh.source.bytes;
  for (std::size_t at = text.find(keyword); at != std::string_view::npos; at = text.find(keyword, at + 1)) {
    const std::size_t end = at + keyword.size();
    const bool begins = at == 0 || text[at - 1] == '\n' || text[at - 1] == '\r';
    if (begins && end < text.size() && (text[end] == ' ' || text[end] == '\t')) {
      return true;
    }
  }
  return false;
}

/// The attributes that no other format has a word for, by their names.
std::vector<std::string> ownNames(const Mesh& mesh) {
  static const std::set<std::string_view> known{
      "vn",        "normal",    "nx",    "ny",  "nz",    "vt",        "texture",
      "texcoord",  "s",         "t",     "u",   "v",     "texture_u", "texture_v",
      "texture_s", "texture_t", "color", "red", "green", "blue",      "alpha"};
  std::vector<std::string> names;
  for (const Attribute& attribute : mesh.attributes) {
    // The normals of an STL file's facets follow from the corners.
    if (!known.contains(attribute.name)) {
      names.push_back(format("'{}'", attribute.name));
    }
  }
  return names;
}

std::vector<std::string> leftOut(const Mesh& mesh, MeshFormat format) {
  std::vector<std::string> names;
  if (const auto normals = io::normalsOf(mesh); normals && !holds(format, mesh, *normals, false)) {
    names.push_back("the normals");
  }
  if (const auto texture = io::textureCoordinatesOf(mesh); texture && !holds(format, mesh, *texture, true)) {
    names.push_back("the texture coordinates");
  }
  const bool isColorless = format == MeshFormat::stl;
  if (isColorless && io::colorsOf(mesh, AttributeDomain::vertex)) {
    names.push_back("the colours of the vertices");
  }
  if ((isColorless || format == MeshFormat::obj) && io::colorsOf(mesh, AttributeDomain::face)) {
    names.push_back("the colours of the faces");
  }
  if (mesh.source.format == MeshFormat::obj && mesh.source.bytes) {
    if (hasStatement(mesh, "g") || hasStatement(mesh, "o")) {
      names.push_back("groups");
    }
    if (hasStatement(mesh, "usemtl")) {
      names.push_back("materials");
    }
  }
  const std::vector<std::string> own = ownNames(mesh);
  names.insert(names.end(), own.begin(), own.end());
  return names;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += i == 0 ? "" : i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  return text;
}

/// STL is a list of triangles.
std::vector<std::string> lostInTriangles(const Mesh& mesh) {
  std::vector<std::string> losses;
  std::vector<bool> isUsed(static_cast<std::size_t>(mesh.vertexCount()), false);
  Index larger = 0;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    larger += mesh.faces[f].size() > 3;
    for (const Index vertex : mesh.faces[f]) {
      isUsed[static_cast<std::size_t>(vertex)] =
          isUsed[static_cast<std::size_t>(vertex)] || mesh.faces[f].size() > 2;
    }
  }
  if (larger > 0) {
    losses.push_back(format("STL holds triangles only: {} of more corners {} cut into them.",
                            larger == 1 ? "one face" : format("{} faces", larger), larger == 1 ? "is" : "are"));
  }
  if (const auto lone = std::count(isUsed.begin(), isUsed.end(), false); lone > 0) {
    losses.push_back(format("STL holds triangles only: {} of no face {} left out.",
                            lone == 1 ? "one vertex" : format("{} vertices", lone), lone == 1 ? "is" : "are"));
  }
  return losses;
}

}  // namespace

std::vector<std::string> exportLosses(const Mesh& mesh, MeshFormat format) {
  if (format == mesh.source.format) {
    return {};
  }
  std::vector<std::string> losses;
  if (const std::vector<std::string> names = leftOut(mesh, format); !names.empty()) {
    losses.push_back(pbffd::format("{} cannot hold {} of {}: left out.", nameOf(format), listed(names),
                                   mesh.source.name.empty() ? "the mesh" : mesh.source.name));
  }
  if (format == MeshFormat::stl) {
    const std::vector<std::string> cut = lostInTriangles(mesh);
    losses.insert(losses.end(), cut.begin(), cut.end());
  }
  return losses;
}

}  // namespace pbffd
