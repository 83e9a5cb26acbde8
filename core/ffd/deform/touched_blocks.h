#pragma once

#include "core/ffd/weights/parameterization.h"

#include <vector>

namespace pbffd {

/// The blocks that each control point touches: the lists of the weights the other way about.
class TouchedBlocks {
 public:
  explicit TouchedBlocks(const Parameterization& weights);

  /// The blocks that any of these control points touches, each once, ascending.
  std::vector<Index> by(const std::vector<Index>& points) const;

  std::size_t bytes() const { return sizeof(Index) * (start_.size() + blocks_.size()); }

 private:
  std::span<const Index> ofPoint(Index point) const;

  Index blockCount_;
  std::vector<Index> start_;  ///< point j has blocks [start_[j], start_[j + 1])
  std::vector<Index> blocks_;
};

}  // namespace pbffd
