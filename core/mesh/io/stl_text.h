#pragma once

#include "core/mesh/io/text_scanner.h"

#include <array>
#include <string_view>
#include <vector>

namespace pbffd::io {

/// The words of a facet, as they stand in the file.
struct StlFacet {
  std::array<std::string_view, 3> normal;
  std::vector<std::array<std::string_view, 3>> corners;
};

/// Goes through an ASCII STL file facet by facet, over any number of solids.
class StlText {
 public:
  explicit StlText(const Input& input) : text_(input, {}) {}

  /// To the next facet; false behind the last solid. Throws InvalidInput where the grammar is broken.
  bool next();
  const StlFacet& facet() const { return facet_; }
  const TextScanner& text() const { return text_; }

 private:
  void expect(std::string_view keyword);
  void readFacet();

  TextScanner text_;
  StlFacet facet_;
  bool isInSolid_ = false;
};

}  // namespace pbffd::io
