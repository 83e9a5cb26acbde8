#include "core/mesh/morton.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <utility>

namespace pbffd {

std::vector<Index> mortonOrderOf(const Points& points, const Bounds& bounds) {
  const MortonCode code(bounds);
  std::vector<std::pair<std::uint64_t, Index>> codes(static_cast<std::size_t>(points.rows()));
  parallelFor(codes.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = static_cast<Index>(i);
      codes[i] = {code(points.row(row).transpose().cwiseMax(bounds.low).cwiseMin(bounds.high)), row};
    }
  });
  parallelSort(codes);
  std::vector<Index> order(codes.size());
  std::transform(codes.begin(), codes.end(), order.begin(), [](const auto& one) { return one.second; });
  return order;
}

}  // namespace pbffd
