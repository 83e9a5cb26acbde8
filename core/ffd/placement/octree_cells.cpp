#include "core/ffd/placement/octree_cells.h"

#include "core/base/parallel.h"
#include "core/mesh/morton.h"

#include <algorithm>
#include <cstdint>

namespace pbffd {
namespace {

struct Code {
  Index group;
  std::uint64_t cell;  ///< the path from the root of the octree
  Index place;
  auto operator<=>(const Code&) const = default;
};

std::vector<Code> sortedCodes(const Points& points, const std::vector<Index>& groups) {
  const MortonCode code(boundsOf(points));
  std::vector<Code> codes(static_cast<std::size_t>(points.rows()));
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const Vec3 point = points.row(static_cast<Index>(i));
    codes[i] = {groups.empty() ? 0 : groups[i], code(point), static_cast<Index>(i)};
  }
  parallelSort(codes);
  return codes;
}

class Splitter {
 public:
  Splitter(const std::vector<Code>& codes, Index capacity) : codes_(codes), capacity_(capacity) {}

  void split(Index begin, Index end, int depth, std::vector<Index>& ends) const {
    if (end - begin <= capacity_ || depth == MortonCode::depth) {
      ends.push_back(end);
      return;
    }
    const int shift = 3 * (MortonCode::depth - 1 - depth);
    while (begin < end) {
      const std::uint64_t cell = codes_[begin].cell >> shift;
      const auto next = std::partition_point(codes_.begin() + begin, codes_.begin() + end,
                                             [&](const Code& code) { return code.cell >> shift == cell; });
      const auto until = static_cast<Index>(next - codes_.begin());
      split(begin, until, depth + 1, ends);
      begin = until;
    }
  }

 private:
  const std::vector<Code>& codes_;
  Index capacity_;
};

}  // namespace

OctreeCells octreeCells(const Points& points, const std::vector<Index>& groups, Index capacity) {
  const std::vector<Code> codes = sortedCodes(points, groups);
  OctreeCells cells;
  cells.order.reserve(codes.size());
  for (const Code& code : codes) {
    cells.order.push_back(code.place);
  }
  cells.start.push_back(0);
  const Splitter splitter(codes, capacity);
  const auto count = static_cast<Index>(codes.size());
  for (Index begin = 0, end; begin < count; begin = end) {
    const auto next = std::partition_point(codes.begin() + begin, codes.end(),
                                           [&](const Code& code) { return code.group == codes[begin].group; });
    end = static_cast<Index>(next - codes.begin());
    splitter.split(begin, end, 0, cells.start);
  }
  return cells;
}

}  // namespace pbffd
