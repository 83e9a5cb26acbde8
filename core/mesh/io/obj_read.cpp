#include "core/base/text.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/obj_statements.h"
#include "core/mesh/io/rows.h"
#include "core/mesh/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace pbffd::io {
namespace {

/// What faces name: vertices, texture coordinates or normals, counted from 1, or backwards from -1. Faces may
/// come before what they name, so that is checked at the end.
class NamedRows {
 public:
  explicit NamedRows(std::string_view what) : what_(what) {}

  void addOne() { ++count_; }
  Index count() const { return count_; }

  /// The row, from 0, that a face on the scanner's line names.
  Index resolve(std::int64_t named, const TextScanner& scanner) {
    constexpr std::int64_t largest = std::numeric_limits<Index>::max();
    if (named == 0) {
      scanner.fail(format("a face names {} 0, but OBJ counts from 1", what_));
    }
    if (named < -count_ || named > largest) {
      scanner.fail(format("a face names {} {}, but the file has {} before it", what_, named, count_));
    }
    if (named < 0) {
      return static_cast<Index>(count_ + named);
    }
    if (named > count_ && (forward_.empty() || named > forward_.back().named)) {
      forward_.push_back({named, scanner.line()});
    }
    return static_cast<Index>(named - 1);
  }

  void checkForward(const Input& input) const {
    for (const Forward& one : forward_) {
      if (one.named > count_) {
        const std::string what = format("a face names {} {}, but the file has {}", what_, one.named, count_);
        input.failAtLine(one.line, what, adviceCutOff);
      }
    }
  }

 private:
  /// The first face to name a row so far beyond those read.
  struct Forward {
    std::int64_t named;
    std::size_t line;
  };
  std::string_view what_;
  Index count_ = 0;
  std::vector<Forward> forward_;
};

/// For each corner a row, -1 where none was named.
class CornerRows {
 public:
  void set(std::size_t corner, Index row) {
    rows_.resize(corner, -1);
    rows_.push_back(row);
  }
  bool empty() const { return rows_.empty(); }
  std::vector<Index> finish(std::size_t corners) {
    rows_.resize(corners, -1);
    return std::move(rows_);
  }

 private:
  std::vector<Index> rows_;
};

class ObjReader {
 public:
  explicit ObjReader(const Input& input) : input_(input), scanner_(input, objSyntax) {}

  Mesh read();

 private:
  void reserve();
  void readStatement(std::string_view keyword);
  void readVertex();
  void readTextureCoordinates();
  void readNormal();
  void readFace();
  void addTextureCoordinates();
  void addNormals();
  void addVertexExtras();

  const Input& input_;
  TextScanner scanner_;
  Mesh mesh_;
  std::vector<double> positions_;
  RaggedRows weights_{1, 1.0};
  RaggedRows colors_{4, 1.0};
  RaggedRows textureCoordinates_{3, 0.0};
  std::vector<double> normals_;
  NamedRows vertexRows_{"vertex"};
  NamedRows textureRows_{"texture coordinates"};
  NamedRows normalRows_{"normal"};
  CornerRows textureOfCorner_;
  CornerRows normalOfCorner_;
  std::vector<Index> corners_;
  OtherStatements others_;
};

void ObjReader::reserve() {
  const ObjCounts counts = estimateObjCounts(input_.bytes);
  positions_.reserve(3 * counts.vertices);
  normals_.reserve(3 * counts.normals);
  mesh_.faces.reserve(counts.faces, 3 * counts.faces);
}

Mesh ObjReader::read() {
  reserve();
  std::size_t statements = 0;
  for (std::string_view word = scanner_.wordAnywhere(); !word.empty(); word = scanner_.firstWordOfNextLine()) {
    readStatement(word);
    if (++statements % stepsToCheckpoint == 0) {
      input_.checkpoint(scanner_.byte());
    }
  }
  for (const NamedRows* rows : {&vertexRows_, &textureRows_, &normalRows_}) {
    rows->checkForward(input_);
  }
  mesh_.positions = Eigen::Map<const Points>(positions_.data(), vertexRows_.count(), 3);
  addTextureCoordinates();
  addNormals();
  addVertexExtras();
  others_.addRemarks(mesh_.remarks);
  return std::move(mesh_);
}

void ObjReader::readStatement(std::string_view keyword) {
  if (keyword == "v") {
    readVertex();
  } else if (keyword == "f" || keyword == "fo") {
    readFace();
  } else if (keyword == "vt") {
    readTextureCoordinates();
  } else if (keyword == "vn") {
    readNormal();
  } else {
    others_.note(keyword, scanner_);
  }
}

void ObjReader::readVertex() {
  if (vertexRows_.count() == std::numeric_limits<Index>::max()) {
    scanner_.fail("the file has more vertices than can be numbered", "Split the mesh.");
  }
  for (int axis = 0; axis < 3; ++axis) {
    positions_.push_back(scanner_.coordinate(scanner_.word(), "a coordinate of a vertex"));
  }
  std::array<double, 4> extras;
  std::size_t count = 0;
  for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
    if (count == extras.size()) {
      scanner_.fail("a vertex has more than 7 numbers");
    }
    extras[count++] = scanner_.number(word, "a weight or colour of a vertex");
  }
  const auto row = static_cast<std::size_t>(vertexRows_.count());
  if (count == 1) {
    weights_.set(row, std::span(extras.data(), 1));
  } else if (count == 3 || count == 4) {
    colors_.set(row, std::span(extras.data(), count));
  } else if (count != 0) {
    scanner_.fail("a vertex has 5 numbers; a position, with a weight or a colour, has 3, 4, 6 or 7");
  }
  vertexRows_.addOne();
}

void ObjReader::readTextureCoordinates() {
  std::array<double, 3> values;
  std::size_t count = 0;
  values[count++] = scanner_.number(scanner_.word(), "a texture coordinate");
  for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
    if (count == values.size()) {
      scanner_.fail("there are more than 3 texture coordinates");
    }
    values[count++] = scanner_.number(word, "a texture coordinate");
  }
  textureCoordinates_.set(static_cast<std::size_t>(textureRows_.count()), std::span(values.data(), count));
  textureRows_.addOne();
}

void ObjReader::readNormal() {
  for (int axis = 0; axis < 3; ++axis) {
    normals_.push_back(scanner_.number(scanner_.word(), "a coordinate of a normal"));
  }
  if (const std::string_view more = scanner_.word(); !more.empty()) {
    scanner_.fail(format("{} follows the three coordinates of a normal", inQuotes(more)));
  }
  normalRows_.addOne();
}

void ObjReader::readFace() {
  corners_.clear();
  std::size_t corner = mesh_.faces.vertices().size();
  for (std::string_view word = scanner_.word(); !word.empty(); word = scanner_.word()) {
    const auto names = parseObjCorner(word);
    if (!names) {
      scanner_.fail(format("{} is no corner of a face: v, v/vt, v//vn or v/vt/vn", inQuotes(word)));
    }
    corners_.push_back(vertexRows_.resolve(names->vertex, scanner_));
    if (names->texture) {
      textureOfCorner_.set(corner, textureRows_.resolve(*names->texture, scanner_));
    }
    if (names->normal) {
      normalOfCorner_.set(corner, normalRows_.resolve(*names->normal, scanner_));
    }
    ++corner;
  }
  if (corner > static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
    scanner_.fail("the faces have more corners than can be numbered", "Split the mesh.");
  }
  mesh_.faces.add(corners_);
}

void remarkOnNonFinite(Mesh& mesh, std::string_view what) {
  const std::vector<double>& values = mesh.attributes.back().values;
  const auto bad = std::count_if(values.begin(), values.end(), [](double x) { return !std::isfinite(x); });
  if (bad > 0) {
    mesh.remarks.push_back(
        format("{} of the {} are no finite numbers; an OBJ export keeps them as they are.", bad, what));
  }
}

void ObjReader::addTextureCoordinates() {
  if (textureCoordinates_.empty()) {
    return;
  }
  const auto rows = static_cast<std::size_t>(textureRows_.count());
  mesh_.attributes.push_back({"vt", AttributeDomain::corner, static_cast<Index>(textureCoordinates_.width()),
                              textureCoordinates_.values(rows),
                              textureOfCorner_.finish(mesh_.faces.vertices().size())});
  remarkOnNonFinite(mesh_, "texture coordinates (vt)");
}

/// Normals that no face names belong to the vertices where there is one for each.
void ObjReader::addNormals() {
  if (normals_.empty()) {
    return;
  }
  const bool areUsed = !normalOfCorner_.empty();
  if (!areUsed && normalRows_.count() == vertexRows_.count()) {
    mesh_.attributes.push_back({"vn", AttributeDomain::vertex, 3, std::move(normals_), {}});
  } else {
    mesh_.attributes.push_back({"vn", AttributeDomain::corner, 3, std::move(normals_),
                                normalOfCorner_.finish(mesh_.faces.vertices().size())});
    if (!areUsed) {
      mesh_.remarks.push_back("No face uses the normals (vn), so a deformation does not turn them.");
    }
  }
  remarkOnNonFinite(mesh_, "numbers of the normals (vn)");
}

void ObjReader::addVertexExtras() {
  const auto rows = static_cast<std::size_t>(vertexRows_.count());
  const std::array<std::pair<std::string_view, const RaggedRows*>, 2> extras{
      {{"w", &weights_}, {"color", &colors_}}};
  for (const auto& [name, column] : extras) {
    if (column->empty()) {
      continue;
    }
    mesh_.attributes.push_back({std::string(name),
                                AttributeDomain::vertex,
                                static_cast<Index>(column->width()),
                                column->values(rows),
                                {}});
    if (column->count() < rows) {
      mesh_.remarks.push_back(format("Only {} of {} vertices have a {}; the others count as 1.",
                                     column->count(), rows, name == "w" ? "weight (w)" : "colour"));
    }
  }
}

}  // namespace

Mesh readObj(const Input& input) {
  return ObjReader(input).read();
}

}  // namespace pbffd::io
