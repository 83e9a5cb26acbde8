#include "app/dataset/raw_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace pbffd {
namespace {

template <class Number>
Number swapped(Number number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  std::reverse(bytes, bytes + sizeof number);
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

template <class Number>
using Stored = Eigen::Matrix<Number, Eigen::Dynamic, 3, Eigen::RowMajor>;

template <class Number>
void swapAll(Stored<Number>& rows) {
  std::transform(rows.data(), rows.data() + rows.size(), rows.data(), swapped<Number>);
}

template <class Number>
Points readAs(const RawFile& file, std::uint64_t at, std::int64_t count, bool isSwapped) {
  Stored<Number> rows(count, 3);
  file.read(at, {reinterpret_cast<char*>(rows.data()), static_cast<std::size_t>(rows.size()) * sizeof(Number)});
  if (isSwapped) {
    swapAll(rows);
  }
  if constexpr (std::is_same_v<Number, double>) {
    return rows;
  } else {
    return rows.template cast<double>();
  }
}

template <class Number>
StoredLengths writeAs(RawFile& file, std::uint64_t at, const Points& rows, bool isSwapped) {
  Stored<Number> stored = rows.cast<Number>();
  double least = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (Eigen::Index i = 0; i < stored.rows(); ++i) {
    const double x = stored(i, 0);
    const double y = stored(i, 1);
    const double z = stored(i, 2);
    const double squared = x * x + y * y + z * z;
    least = std::min(least, squared);
    largest = std::max(largest, squared);
  }
  if (isSwapped) {
    swapAll(stored);
  }
  file.write(at, {reinterpret_cast<const char*>(stored.data()),
                  static_cast<std::size_t>(stored.size()) * sizeof(Number)});
  return {std::sqrt(least), std::sqrt(largest)};
}

}  // namespace

Points readRows(const RawFile& file, const RawArray& array, std::int64_t first, std::int64_t count,
                bool isSwapped) {
  const std::uint64_t at = array.begin + array.rowBytes() * static_cast<std::uint64_t>(first);
  return array.isDouble ? readAs<double>(file, at, count, isSwapped)
                        : readAs<float>(file, at, count, isSwapped);
}

StoredLengths writeRows(RawFile& file, const RawArray& array, std::int64_t first, const Points& rows,
                        const RowPlace& place) {
  const std::uint64_t at = array.begin + place.shift + array.rowBytes() * static_cast<std::uint64_t>(first);
  return array.isDouble ? writeAs<double>(file, at, rows, place.isSwapped)
                        : writeAs<float>(file, at, rows, place.isSwapped);
}

}  // namespace pbffd
