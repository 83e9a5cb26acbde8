#include "core/base/text.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/ply_body.h"
#include "core/mesh/io/ply_strips.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace pbffd::io {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The list of vertices of a face or strip, by either of its names.
std::optional<std::size_t> findVertexList(const PlyElement& element) {
  const auto found = element.find("vertex_indices");
  return found ? found : element.find("vertex_index");
}

class PlyReader {
 public:
  explicit PlyReader(const Input& input)
      : input_(input), header_(parsePlyHeader(input)), body_(input, header_) {}

  Mesh read();

 private:
  void readVertices(const PlyElement& element);
  void readFaces(const PlyElement& element);
  void readStrips(const PlyElement& element);
  void readOther(const PlyElement& element);
  void readCorners(const PlyProperty& property, bool isStrip);
  void readTexture(const PlyProperty& property);
  Attribute& column(const PlyProperty& property, AttributeDomain domain);
  std::size_t listOfVertices(const PlyElement& element);
  void takePositions(const PlyElement& element);
  void checkCorners() const;
  void checkpoint(std::size_t row) const;
  void remarkOnLists(const PlyElement& element, std::string_view known);
  void finish();

  const Input& input_;
  PlyHeader header_;
  PlyBody body_;
  Mesh mesh_;
  std::vector<Index> corners_;
  std::vector<double> texture_;
  std::vector<Index> textureOfCorner_;
  std::size_t otherTextures_ = 0;
};

Mesh PlyReader::read() {
  const PlyElement* vertices = header_.find("vertex");
  if (vertices == nullptr) {
    input_.fail("Its header has no element \"vertex\"", "Export it as a polygon mesh.");
  }
  if (vertices->count > static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
    input_.fail("It has more vertices than can be numbered", "Split the mesh.");
  }
  for (const PlyElement& element : header_.elements) {
    body_.checkRoom(element);
    if (element.name == "vertex") {
      readVertices(element);
    } else if (element.name == "face") {
      readFaces(element);
    } else if (element.name == "tristrips") {
      readStrips(element);
    } else {
      readOther(element);
    }
  }
  finish();
  return std::move(mesh_);
}

void PlyReader::checkpoint(std::size_t row) const {
  if (row % stepsToCheckpoint == 0) {
    input_.checkpoint(body_.byte());
  }
}

/// Adds an attribute of one number a row.
Attribute& PlyReader::column(const PlyProperty& property, AttributeDomain domain) {
  mesh_.attributes.push_back({property.name, domain, 1, {}, {}});
  return mesh_.attributes.back();
}

void PlyReader::readVertices(const PlyElement& element) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  std::vector<int> axisOf(element.properties.size(), -1);
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const auto found = element.find(axes[axis]);
    if (!found || element.properties[*found].countType) {
      input_.fail(format("Its vertices have no property {}", inQuotes(axes[axis])),
                  "Export it as a polygon mesh.");
    }
    axisOf[*found] = static_cast<int>(axis);
  }
  // One column a property that is neither a coordinate nor a list; none has been added before.
  std::vector<std::size_t> columnOf(element.properties.size());
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    if (axisOf[p] < 0 && !element.properties[p].countType) {
      columnOf[p] = mesh_.attributes.size();
      column(element.properties[p], AttributeDomain::vertex).values.resize(element.count);
    }
  }
  mesh_.positions.resize(static_cast<Eigen::Index>(element.count), 3);
  for (std::size_t row = 0; row < element.count; ++row) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.countType) {
        body_.skip(property);
        continue;
      }
      const double value = body_.number(property.type);
      if (axisOf[p] < 0) {
        mesh_.attributes[columnOf[p]].values[row] = value;
        continue;
      }
      if (!std::isfinite(value)) {
        body_.fail(format("{} of vertex {} is {}, which is not a finite number", property.name, row, value));
      }
      mesh_.positions(static_cast<Eigen::Index>(row), axisOf[p]) = value;
    }
    checkpoint(row);
  }
  remarkOnLists(element, "");
}

/// Its place among the properties.
std::size_t PlyReader::listOfVertices(const PlyElement& element) {
  const auto found = findVertexList(element);
  if (!found || !element.properties[*found].countType) {
    input_.fail(format("Its element {} has no list \"vertex_indices\"", inQuotes(element.name)),
                "Export it as a polygon mesh.");
  }
  return *found;
}

/// Into corners_.
void PlyReader::readCorners(const PlyProperty& property, bool isStrip) {
  corners_.clear();
  const auto vertices = static_cast<std::int64_t>(header_.find("vertex")->count);
  for (std::size_t left = body_.listLength(property); left > 0; --left) {
    std::int64_t vertex = body_.integer(property.type);
    if (isStrip && property.type == PlyType::uint32 && vertex == std::numeric_limits<std::uint32_t>::max()) {
      vertex = -1;
    }
    if (vertex >= vertices || vertex < (isStrip ? -1 : 0)) {
      body_.fail(format("a {} names vertex {}, but the file has {}, counted from 0", isStrip ? "strip" : "face",
                        vertex, vertices),
                 adviceCutOff);
    }
    corners_.push_back(static_cast<Index>(vertex));
    checkpoint(left);
  }
}

void PlyReader::checkCorners() const {
  if (mesh_.faces.vertices().size() > static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
    body_.fail("the faces have more corners than can be numbered", "Split the mesh.");
  }
}

/// MeshLab's texture coordinates: a list of two numbers for each corner of a face. They come behind the
/// corners; a list of another length is left to the source.
void PlyReader::readTexture(const PlyProperty& property) {
  const std::size_t length = body_.listLength(property);
  const bool isKnown = length == 2 * corners_.size();
  if (isKnown) {
    textureOfCorner_.resize(mesh_.faces.vertices().size() - corners_.size(), -1);
    for (std::size_t corner = 0; corner < corners_.size(); ++corner) {
      textureOfCorner_.push_back(static_cast<Index>(texture_.size() / 2 + corner));
    }
  }
  otherTextures_ += isKnown || length == 0 ? 0 : 1;
  for (std::size_t i = 0; i < length; ++i) {
    const double value = body_.number(property.type);
    if (isKnown) {
      texture_.push_back(value);
    }
  }
}

void PlyReader::readFaces(const PlyElement& element) {
  const std::size_t list = listOfVertices(element);
  // Texture coordinates are understood behind the corners that they belong to.
  const std::size_t texture = element.find("texcoord").value_or(list);
  const std::size_t firstColumn = mesh_.attributes.size();
  for (const PlyProperty& property : element.properties) {
    if (!property.countType) {
      std::vector<double>& values = column(property, AttributeDomain::face).values;
      values.reserve(element.count);
      values.resize(static_cast<std::size_t>(mesh_.faces.size()), unknown);
    }
  }
  for (std::size_t row = 0; row < element.count; ++row) {
    std::size_t at = firstColumn;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (p == list) {
        readCorners(property, false);
        mesh_.faces.add(corners_);
      } else if (p == texture && p > list && property.countType) {
        readTexture(property);
      } else if (property.countType) {
        body_.skip(property);
      } else {
        mesh_.attributes[at++].values.push_back(body_.number(property.type));
      }
    }
    checkpoint(row);
  }
  checkCorners();
  remarkOnLists(element, texture > list ? "texcoord" : "");
  if (otherTextures_ > 0) {
    mesh_.remarks.push_back(format(
        "{} of \"texcoord\" do not have two numbers a corner; a PLY export keeps them, but they are not read.",
        counted(otherTextures_, "list", "lists")));
  }
}

void PlyReader::readStrips(const PlyElement& element) {
  const std::size_t list = listOfVertices(element);
  StripTriangles triangles;
  for (std::size_t row = 0; row < element.count; ++row) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (p != list) {
        body_.skip(element.properties[p]);
        continue;
      }
      readCorners(element.properties[p], true);
      triangles.add(corners_, mesh_.faces);
    }
    checkpoint(row);
  }
  checkCorners();
  if (triangles.joining() > 0) {
    mesh_.remarks.push_back(format("{} of the strips only join their parts and are no faces.",
                                   counted(triangles.joining(), "triangle", "triangles")));
  }
  if (element.properties.size() > 1) {
    mesh_.remarks.push_back("A PLY export keeps what the strips have beside their vertices; it is not shown.");
  }
}

void PlyReader::readOther(const PlyElement& element) {
  for (std::size_t row = 0; row < element.count && !element.properties.empty(); ++row) {
    for (const PlyProperty& property : element.properties) {
      body_.skip(property);
    }
    checkpoint(row);
  }
  if (element.count > 0) {
    mesh_.remarks.push_back(format("The element {} ({}) is kept by a PLY export but not shown.",
                                   inQuotes(element.name), counted(element.count, "row", "rows")));
  }
}

void PlyReader::remarkOnLists(const PlyElement& element, std::string_view known) {
  for (const PlyProperty& property : element.properties) {
    const bool isRead = property.name == known || findVertexList(element) == element.find(property.name);
    if (property.countType && !isRead) {
      mesh_.remarks.push_back(format("The list {} of the element {} is kept by a PLY export but not shown.",
                                     inQuotes(property.name), inQuotes(element.name)));
    }
  }
}

void PlyReader::finish() {
  // Strips come beside faces, with no row in what the faces have.
  for (Attribute& attribute : mesh_.attributes) {
    if (attribute.domain == AttributeDomain::face) {
      attribute.values.resize(static_cast<std::size_t>(mesh_.faces.size()), unknown);
    }
  }
  if (!texture_.empty()) {
    textureOfCorner_.resize(mesh_.faces.vertices().size(), -1);
    mesh_.attributes.push_back(
        {"texcoord", AttributeDomain::corner, 2, std::move(texture_), std::move(textureOfCorner_)});
  }
  if (const std::size_t rest = body_.rest(); rest > 0) {
    mesh_.remarks.push_back(
        format("The last {} behind the data are kept by a PLY export.", counted(rest, "byte", "bytes")));
  }
}

}  // namespace

Mesh readPly(const Input& input) {
  return PlyReader(input).read();
}

}  // namespace pbffd::io
