#include "core/mesh/io/off_scanner.h"

#include "core/base/text.h"

namespace pbffd::io {
namespace {

constexpr std::string_view adviceOtherFormat = "Choose an OFF file, or give the file the ending of its format.";

bool take(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) {
    return false;
  }
  word.remove_prefix(prefix.size());
  return true;
}

}  // namespace

OffScanner::OffScanner(const Input& input) : text_(input, {.hasComments = true}) {
  readKeyword();
  readCounts();
}

void OffScanner::readKeyword() {
  const std::string_view word = text_.wordAnywhere();
  std::string_view rest = word;
  header_.hasTexture = take(rest, "ST");
  header_.hasColors = take(rest, "C");
  header_.hasNormals = take(rest, "N");
  const bool isHigher = take(rest, "4") || take(rest, "n");
  if (!take(rest, "OFF")) {
    text_.fail(format("the file begins with {} and not with OFF", inQuotes(word)), adviceOtherFormat);
  }
  if (isHigher) {
    text_.fail(format("{} holds points of more than three dimensions", inQuotes(word)),
               "Export the mesh with three coordinates a vertex.");
  }
  countsInKeyword_ = rest;
}

std::size_t OffScanner::count(std::string_view word, std::string_view what) {
  const std::int64_t value = text_.integer(word, what);
  if (value < 0) {
    text_.fail(format("{} is {}", what, value));
  }
  return static_cast<std::size_t>(value);
}

void OffScanner::readCounts() {
  std::string_view word = countsInKeyword_.empty() ? text_.wordAnywhere() : countsInKeyword_;
  if (word == "BINARY") {
    text_.fail("this is a binary OFF file, which is not read", "Export it as text, or as PLY.");
  }
  header_.vertices = count(word, "the number of vertices");
  const std::size_t line = text_.line();
  header_.faces = count(text_.wordAnywhere(), "the number of faces");
  // The number of edges may be missing where the others stand on one line.
  const bool areOnOneLine = text_.line() == line;
  word = areOnOneLine ? text_.word() : text_.wordAnywhere();
  if (!areOnOneLine || !word.empty()) {
    count(word, "the number of edges");
  }
  // A vertex takes six bytes at least ("0 0 0" and a line end), a face two.
  const std::size_t room = text_.input().bytes.size() - text_.byte() + 1;
  if (header_.vertices > room / 6 || header_.faces > room / 2) {
    text_.fail(format("the file promises {} vertices and {} faces, but only {} bytes follow", header_.vertices,
                      header_.faces, room - 1),
               adviceCutOff);
  }
}

OffVertex OffScanner::nextVertex() {
  OffVertex vertex;
  for (std::string_view& word : vertex.position) {
    word = text_.wordAnywhere();
  }
  if (header_.hasNormals) {
    for (std::string_view& word : vertex.normal) {
      word = text_.wordAnywhere();
    }
  }
  return vertex;
}

}  // namespace pbffd::io
