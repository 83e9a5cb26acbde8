#pragma once

#include "core/base/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace pbffd::io {

/// Rows of numbers of which some are shorter than others or missing, gathered in ascending order.
class RaggedRows {
 public:
  /// Rows hold up to `widest` numbers; what a row lacks is `fallback`.
  RaggedRows(std::size_t widest, double fallback) : widest_(widest), fallback_(fallback) {}

  /// At most `widest` numbers; rows that were left out before it are all fallback.
  void set(std::size_t row, std::span<const double> numbers);

  /// Numbers in the longest row.
  std::size_t width() const { return width_; }
  /// Rows that were set.
  std::size_t count() const { return count_; }
  bool empty() const { return count_ == 0; }

  /// rows x width(), row after row.
  std::vector<double> values(std::size_t rows) const;

 private:
  std::size_t widest_;
  double fallback_;
  std::size_t width_ = 0;
  std::size_t count_ = 0;
  std::vector<double> values_;
};

}  // namespace pbffd::io
