#pragma once

#include "app/dataset/raw_file.h"
#include "app/dataset/raw_xml_layout.h"
#include "core/base/types.h"

namespace pbffd {

/// Rows of an array of three numbers each, as they stand in the file.
Points readRows(const RawFile& file, const RawArray& array, std::int64_t first, std::int64_t count,
                bool isSwapped);

/// The least and largest length of the rows as they were stored.
struct StoredLengths {
  double least;
  double largest;
};

/// Where an array stands in the file that is written: `shift` bytes later, perhaps in the other byte order.
struct RowPlace {
  std::uint64_t shift;
  bool isSwapped;
};
StoredLengths writeRows(RawFile& file, const RawArray& array, std::int64_t first, const Points& rows,
                        const RowPlace& place);

}  // namespace pbffd
