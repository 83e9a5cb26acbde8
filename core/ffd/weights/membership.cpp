#include "core/ffd/weights/membership.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <numeric>

namespace pbffd {
namespace {

/// Calls visit(entry of the membership) for those in blocks [begin, end).
template <class Visit>
void forEachEntry(const Membership& membership, Index begin, Index end, const Visit& visit) {
  const auto first = std::lower_bound(membership.blocks.begin(), membership.blocks.end(), begin);
  for (auto at = first; at != membership.blocks.end() && *at < end; ++at) {
    visit(static_cast<std::size_t>(at - membership.blocks.begin()));
  }
}

}  // namespace

Membership pointsInside(const PointBlocks& blocks, const Region& region) {
  Membership inside;
  blocks.forEachNear(region, [&](Index block, bool isWhole) {
    if (const std::uint16_t mask = isWhole ? blocks.all(block) : blocks.inside(block, region); mask != 0) {
      inside.blocks.push_back(block);
      inside.members.push_back(mask);
    }
  });
  return inside;
}

BlockLists listsOf(const std::vector<Membership>& memberships, Index blockCount) {
  constexpr std::size_t grain = 2048;
  const auto count = static_cast<std::size_t>(blockCount);
  BlockLists lists;
  lists.start.assign(count + 1, 0);
  parallelFor(count, grain, [&](std::size_t begin, std::size_t end) {
    for (const Membership& membership : memberships) {
      forEachEntry(membership, static_cast<Index>(begin), static_cast<Index>(end),
                   [&](std::size_t e) { ++lists.start[static_cast<std::size_t>(membership.blocks[e]) + 1]; });
    }
  });
  std::partial_sum(lists.start.begin(), lists.start.end(), lists.start.begin());
  lists.points.resize(static_cast<std::size_t>(lists.start.back()));
  lists.members.resize(lists.points.size());
  parallelFor(count, grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> next(lists.start.begin() + static_cast<std::ptrdiff_t>(begin),
                            lists.start.begin() + static_cast<std::ptrdiff_t>(end));
    for (std::size_t j = 0; j < memberships.size(); ++j) {
      forEachEntry(memberships[j], static_cast<Index>(begin), static_cast<Index>(end), [&](std::size_t e) {
        const std::size_t block = static_cast<std::size_t>(memberships[j].blocks[e]);
        const auto at = static_cast<std::size_t>(next[block - begin]++);
        lists.points[at] = static_cast<Index>(j);
        lists.members[at] = memberships[j].members[e];
      });
    }
  });
  return lists;
}

}  // namespace pbffd
