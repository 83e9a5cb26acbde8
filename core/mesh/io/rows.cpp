#include "core/mesh/io/rows.h"

#include <algorithm>

namespace pbffd::io {

void RaggedRows::set(std::size_t row, std::span<const double> numbers) {
  values_.resize(row * widest_, fallback_);
  values_.insert(values_.end(), numbers.begin(), numbers.end());
  values_.resize((row + 1) * widest_, fallback_);
  width_ = std::max(width_, numbers.size());
  ++count_;
}

std::vector<double> RaggedRows::values(std::size_t rows) const {
  std::vector<double> result(rows * width_, fallback_);
  const std::size_t known = std::min(rows, values_.size() / widest_);
  for (std::size_t row = 0; row < known; ++row) {
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(row * widest_), width_,
                result.begin() + static_cast<std::ptrdiff_t>(row * width_));
  }
  return result;
}

}  // namespace pbffd::io
