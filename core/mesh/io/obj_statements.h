#pragma once

#include "core/mesh/io/text_scanner.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pbffd::io {

inline constexpr TextSyntax objSyntax{.hasComments = true, .hasContinuations = true};

/// A corner of a face as OBJ writes it: v, v/vt, v//vn or v/vt/vn.
struct ObjCorner {
  std::int64_t vertex = 0;
  std::optional<std::int64_t> texture;
  std::optional<std::int64_t> normal;
};
/// Nothing where the word is no corner.
std::optional<ObjCorner> parseObjCorner(std::string_view word);

/// About how many statements of each kind a file has, to set room aside: from the first letters of its lines.
struct ObjCounts {
  std::size_t vertices = 0;
  std::size_t normals = 0;
  std::size_t faces = 0;
};
ObjCounts estimateObjCounts(std::string_view bytes);

/// Keeps account of the statements that give the mesh neither vertices nor faces.
class OtherStatements {
 public:
  /// Throws InvalidInput where the keyword shows that the file is no text.
  void note(std::string_view keyword, const TextScanner& scanner);

  /// A sentence for each kind that is not shown. Groups, objects, smoothing and materials need none.
  void addRemarks(std::vector<std::string>& remarks) const;

 private:
  struct Kind {
    std::size_t count = 0;
    std::size_t firstLine = 0;
    std::string firstWord;
  };
  Kind elements_;  ///< points and lines
  Kind freeForm_;
  Kind calls_;
  Kind unknown_;
};

}  // namespace pbffd::io
