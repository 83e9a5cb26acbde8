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
  // First the blocks alone, so that those whose points are to be looked at can be fetched in time.
  constexpr std::size_t fetchedAhead = 8;
  Membership found;
  blocks.forEachNear(region, [&](Index begin, Index end, bool isWhole) {
    for (Index block = begin; block < end; ++block) {
      found.blocks.push_back(block);
      found.members.push_back(isWhole ? blocks.all(block) : std::uint16_t{0});
    }
  });
  std::size_t count = 0;
  for (std::size_t e = 0; e < found.blocks.size(); ++e) {
    if (const std::size_t next = e + fetchedAhead; next < found.blocks.size() && found.members[next] == 0) {
      const double* numbers = blocks.numbers(found.blocks[next]);
      for (std::size_t line = 0; line < 48; line += 8) {
        __builtin_prefetch(numbers + line);
      }
    }
    const Index block = found.blocks[e];
    const std::uint16_t members = found.members[e] != 0 ? found.members[e] : blocks.inside(block, region);
    found.blocks[count] = block;
    found.members[count] = members;
    count += members != 0;
  }
  found.blocks.resize(count);
  found.members.resize(count);
  return found;
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
