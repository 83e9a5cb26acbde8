#pragma once

#include "app/dataset/raw_rows.h"
#include "app/dataset/raw_xml_layout.h"

#include <limits>
#include <string>
#include <vector>

namespace pbffd {

/// The least and largest length of an array's rows, as VTK notes them in the header.
struct LengthRange {
  double least = std::numeric_limits<double>::infinity();
  double largest = 0.0;

  void add(const StoredLengths& lengths);
};

/// The header of a file whose arrays change: as long as it will be, before their lengths are known.
class RawHeader {
 public:
  RawHeader(const std::string& text, const std::vector<const RawArray*>& arrays);

  std::size_t size() const { return text_.size(); }

  /// The header with these lengths, one range an array.
  std::string filled(const std::vector<LengthRange>& lengths) const;

 private:
  struct Room {
    RawArray::Range range;
    std::size_t array;
    std::size_t begin;
    std::string quote;  ///< that ends an attribute; empty for the text of an element
  };
  std::string text_;
  std::vector<Room> rooms_;
};

}  // namespace pbffd
