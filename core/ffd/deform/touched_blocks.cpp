#include "core/ffd/deform/touched_blocks.h"

#include <cstdint>
#include <numeric>

namespace pbffd {

TouchedBlocks::TouchedBlocks(const Parameterization& weights)
    : blockCount_(weights.blockCount()),
      start_(static_cast<std::size_t>(weights.pointCount) + 1, 0),
      blocks_(weights.points.size()) {
  for (const Index j : weights.points) {
    ++start_[static_cast<std::size_t>(j) + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (Index block = 0; block < blockCount_; ++block) {
    for (const Index j : weights.list(block).points) {
      blocks_[static_cast<std::size_t>(next[static_cast<std::size_t>(j)]++)] = block;
    }
  }
}

std::span<const Index> TouchedBlocks::ofPoint(Index point) const {
  const auto j = static_cast<std::size_t>(point);
  return std::span<const Index>(blocks_).subspan(static_cast<std::size_t>(start_[j]),
                                                 static_cast<std::size_t>(start_[j + 1] - start_[j]));
}

std::vector<Index> TouchedBlocks::by(const std::vector<Index>& points) const {
  if (points.empty()) {
    return {};
  }
  if (points.size() == 1) {
    const auto only = ofPoint(points.front());
    return {only.begin(), only.end()};
  }
  std::vector<std::uint8_t> isTouched(static_cast<std::size_t>(blockCount_), 0);
  for (const Index j : points) {
    for (const Index block : ofPoint(j)) {
      isTouched[static_cast<std::size_t>(block)] = 1;
    }
  }
  std::vector<Index> touched;
  for (Index block = 0; block < blockCount_; ++block) {
    if (isTouched[static_cast<std::size_t>(block)] != 0) {
      touched.push_back(block);
    }
  }
  return touched;
}

}  // namespace pbffd
