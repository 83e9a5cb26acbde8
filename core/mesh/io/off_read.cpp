#include "core/base/text.h"
#include "core/mesh/io/formats.h"
#include "core/mesh/io/off_scanner.h"
#include "core/mesh/io/rows.h"

#include <limits>
#include <utility>

namespace pbffd::io {
namespace {

constexpr std::size_t longestColor = 4;

class OffReader {
 public:
  explicit OffReader(const Input& input)
      : input_(input), scanner_(input), header_(scanner_.header()), text_(scanner_.text()) {}

  Mesh read();

 private:
  void readVertex(std::size_t row);
  void readVertexExtras(std::size_t row);
  void readFace(std::size_t row);
  std::vector<double> restOfLine();
  void failCutOff(std::string_view what, std::size_t done, std::size_t all);
  void addAttributes();
  void remarkOnRest();

  const Input& input_;
  OffScanner scanner_;
  const OffHeader& header_;
  TextScanner& text_;
  Mesh mesh_;
  std::vector<double> normals_;
  RaggedRows colors_{longestColor, 1.0};
  RaggedRows texture_{2, 0.0};
  RaggedRows faceColors_{longestColor, std::numeric_limits<double>::quiet_NaN()};
  std::vector<Index> corners_;
};

Mesh OffReader::read() {
  if (header_.vertices > static_cast<std::size_t>(std::numeric_limits<Index>::max())) {
    text_.fail("the file has more vertices than can be numbered", "Split the mesh.");
  }
  mesh_.positions.resize(static_cast<Eigen::Index>(header_.vertices), 3);
  for (std::size_t row = 0; row < header_.vertices; ++row) {
    readVertex(row);
  }
  for (std::size_t row = 0; row < header_.faces; ++row) {
    readFace(row);
  }
  remarkOnRest();
  addAttributes();
  return std::move(mesh_);
}

void OffReader::failCutOff(std::string_view what, std::size_t done, std::size_t all) {
  text_.fail(format("the file ends after {} of {} {}", done, all, what), adviceCutOff);
}

void OffReader::readVertex(std::size_t row) {
  const OffVertex vertex = scanner_.nextVertex();
  if (vertex.position[2].empty()) {
    failCutOff("vertices", row, header_.vertices);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    mesh_.positions(static_cast<Eigen::Index>(row), axis) =
        text_.coordinate(vertex.position[at], "a coordinate of a vertex");
    if (header_.hasNormals) {
      normals_.push_back(text_.number(vertex.normal[at], "a coordinate of a normal"));
    }
  }
  readVertexExtras(row);
  if (row % stepsToCheckpoint == 0) {
    input_.checkpoint(text_.byte());
  }
}

std::vector<double> OffReader::restOfLine() {
  std::vector<double> numbers;
  for (std::string_view word = text_.word(); !word.empty(); word = text_.word()) {
    if (numbers.size() == longestColor + 2) {
      text_.fail(format("{} is one number too many", inQuotes(word)));
    }
    numbers.push_back(text_.number(word, "a colour or texture coordinate"));
  }
  return numbers;
}

/// A colour of 3 or 4 numbers, or of 1 into a table, and then two texture coordinates.
void OffReader::readVertexExtras(std::size_t row) {
  const std::vector<double> numbers = restOfLine();
  const std::size_t textures = header_.hasTexture ? 2 : 0;
  const std::size_t colors = numbers.size() - std::min(numbers.size(), textures);
  if (numbers.size() < textures || colors == 2 || colors > longestColor) {
    text_.fail(format("a vertex has {} numbers behind its position, which are no colour{}", numbers.size(),
                      header_.hasTexture ? " and texture coordinates" : ""));
  }
  const std::span<const double> all(numbers);
  if (colors > 0) {
    colors_.set(row, all.first(colors));
  }
  if (textures > 0) {
    texture_.set(row, all.last(textures));
  }
}

void OffReader::readFace(std::size_t row) {
  const std::string_view first = text_.wordAnywhere();
  if (first.empty()) {
    failCutOff("faces", row, header_.faces);
  }
  const std::int64_t size = text_.integer(first, "the number of corners of a face");
  if (size < 0) {
    text_.fail(format("a face has {} corners", size));
  }
  corners_.clear();
  for (std::int64_t corner = 0; corner < size; ++corner) {
    const std::string_view word = text_.wordAnywhere();
    if (word.empty()) {
      failCutOff("faces", row, header_.faces);
    }
    const std::int64_t vertex = text_.integer(word, "a vertex of a face");
    if (vertex < 0 || vertex >= static_cast<std::int64_t>(header_.vertices)) {
      text_.fail(
          format("a face names vertex {}, but the file has {}, counted from 0", vertex, header_.vertices));
    }
    corners_.push_back(static_cast<Index>(vertex));
  }
  mesh_.faces.add(corners_);
  const std::vector<double> color = restOfLine();
  if (color.size() > longestColor) {
    text_.fail(format("the colour of a face has {} numbers", color.size()));
  }
  if (!color.empty()) {
    faceColors_.set(row, color);
  }
  if (row % stepsToCheckpoint == 0) {
    input_.checkpoint(text_.byte());
  }
}

void OffReader::addAttributes() {
  if (header_.hasNormals) {
    mesh_.attributes.push_back({"normal", AttributeDomain::vertex, 3, std::move(normals_), {}});
  }
  const auto add = [&](const RaggedRows& rows, std::string_view name, AttributeDomain domain, std::size_t all) {
    if (rows.empty()) {
      return;
    }
    mesh_.attributes.push_back(
        {std::string(name), domain, static_cast<Index>(rows.width()), rows.values(all), {}});
    if (rows.count() < all) {
      mesh_.remarks.push_back(format("Only {} of {} {} have a colour.", rows.count(), all,
                                     domain == AttributeDomain::face ? "faces" : "vertices"));
    }
  };
  add(colors_, "color", AttributeDomain::vertex, header_.vertices);
  add(texture_, "texture", AttributeDomain::vertex, header_.vertices);
  add(faceColors_, "color", AttributeDomain::face, header_.faces);
}

void OffReader::remarkOnRest() {
  if (!text_.wordAnywhere().empty()) {
    mesh_.remarks.push_back(format(
        "What follows the last face, from line {}, is kept by an OFF export but not shown.", text_.line()));
  }
}

}  // namespace

Mesh readOff(const Input& input) {
  return OffReader(input).read();
}

}  // namespace pbffd::io
