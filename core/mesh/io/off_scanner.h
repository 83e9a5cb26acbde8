#pragma once

#include "core/mesh/io/text_scanner.h"

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace pbffd::io {

/// The first lines of an OFF file: which numbers a vertex has, and how many vertices and faces follow.
struct OffHeader {
  bool hasTexture = false;  ///< ST: two texture coordinates at the end of a vertex
  bool hasColors = false;   ///< C
  bool hasNormals = false;  ///< N: three numbers behind the position
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

/// The words of a vertex, as they stand in the file.
struct OffVertex {
  std::array<std::string_view, 3> position;
  std::array<std::string_view, 3> normal;  ///< empty words where the file has none
};

/// Goes through an OFF file in order: the header, the vertices, the faces.
class OffScanner {
 public:
  /// Reads the header. Throws InvalidInput where it is none, or promises more than the file has room for.
  explicit OffScanner(const Input& input);

  const OffHeader& header() const { return header_; }
  TextScanner& text() { return text_; }

  /// The position and normal of the next vertex; what follows on its line stays for `text()`.
  OffVertex nextVertex();

 private:
  void readKeyword();
  void readCounts();
  std::size_t count(std::string_view word, std::string_view what);

  TextScanner text_;
  OffHeader header_;
  std::string_view countsInKeyword_;  ///< what follows OFF without a space, as some programs write it
};

}  // namespace pbffd::io
