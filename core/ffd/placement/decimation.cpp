#include "core/ffd/placement/decimation.h"

#include "core/base/parallel.h"
#include "core/ffd/placement/dense_merging.h"
#include "core/ffd/placement/octree_cells.h"
#include "core/ffd/placement/partner_search.h"

#include <algorithm>
#include <cstdint>
#include <queue>
#include <tuple>

namespace pbffd {
namespace {

/// Up to so many points plain arrays are faster than a tree.
constexpr Index fewPoints = 512;

/// The best merge of `owner`, as it was when it was looked for, or the nearest.
struct Candidate {
  double cost;
  Index low;
  Index high;
  Index owner;
  std::uint32_t ownerVersion;
  std::uint32_t partnerVersion;
  bool isSure;  ///< else the rules have still to be asked: the cost is the least that it may be

  Index partner() const { return owner == low ? high : low; }
  bool operator<(const Candidate& other) const {
    // std::priority_queue keeps the greatest on top: the lowest cost is the greatest.
    return std::tie(other.cost, other.low, other.high) < std::tie(cost, low, high);
  }
};

/// Every point has one candidate in the queue at most. A candidate whose partner changed is looked for
/// again only when it comes up: since then its cost can only have grown. Nor are the rules asked before.
class ClosestFirst {
 public:
  ClosestFirst(const Points& points, const MergeRules& rules)
      : search_(points, rules), count_(static_cast<Index>(points.rows())) {
    std::vector<PartnerSearch::Partner> partners(static_cast<std::size_t>(count_));
    parallelFor(partners.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        partners[i] = search_.nearest(static_cast<Index>(i));
      }
    });
    std::vector<Candidate> candidates;
    candidates.reserve(partners.size());
    for (std::size_t i = 0; i < partners.size(); ++i) {
      if (partners[i].place >= 0) {
        candidates.push_back(candidate(static_cast<Index>(i), partners[i], false));
      }
    }
    queue_ = std::priority_queue<Candidate>({}, std::move(candidates));
  }

  Index aliveCount() const { return search_.aliveCount(); }

  /// Merges the closest pair; false when none may merge.
  bool mergeOne(std::vector<Merge>& merges) {
    while (!queue_.empty()) {
      const Candidate top = queue_.top();
      queue_.pop();
      if (!search_.isAlive(top.owner) || search_.version(top.owner) != top.ownerVersion) {
        continue;
      }
      if (!search_.isAlive(top.partner()) || search_.version(top.partner()) != top.partnerVersion) {
        push(top.owner);
        continue;
      }
      if (!top.isSure && search_.factorOf(top.low, top.high) != 1.0) {
        pushBest(top.owner);
        continue;
      }
      search_.merge(top.low, top.high);
      merges.push_back({top.low, top.high});
      push(top.low);
      return true;
    }
    return false;
  }

  MergedPoints result(std::vector<Merge> merges) const {
    MergedPoints merged{Points(search_.aliveCount(), 3), {}, std::move(merges)};
    for (Index place = 0; place < count_; ++place) {
      if (search_.isAlive(place)) {
        merged.points.row(static_cast<Index>(merged.places.size())) = search_.point(place);
        merged.places.push_back(place);
      }
    }
    return merged;
  }

 private:
  Candidate candidate(Index owner, const PartnerSearch::Partner& partner, bool isSure) const {
    return {partner.cost, std::min(owner, partner.place), std::max(owner, partner.place),
            owner,        search_.version(owner),         search_.version(partner.place),
            isSure};
  }
  void push(Index owner) {
    if (const auto partner = search_.nearest(owner); partner.place >= 0) {
      queue_.push(candidate(owner, partner, false));
    }
  }
  void pushBest(Index owner) {
    if (const auto partner = search_.best(owner); partner.place >= 0) {
      queue_.push(candidate(owner, partner, true));
    }
  }

  PartnerSearch search_;
  Index count_;
  std::priority_queue<Candidate> queue_;
};

std::vector<Index> groupsAt(const std::vector<Index>& groups, const std::vector<Index>& places) {
  std::vector<Index> result;
  if (!groups.empty()) {
    result.reserve(places.size());
    std::transform(places.begin(), places.end(), std::back_inserter(result),
                   [&](Index place) { return groups[place]; });
  }
  return result;
}

/// One pass: every cell gives up its share of points.
Decimated decimateCells(const Points& points, double ratio, const MergeRules& rules, const Progress& progress) {
  const OctreeCells cells = octreeCells(points, rules.groups);
  std::vector<MergedPoints> results(cells.start.size() - 1);
  parallelFor(results.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      if (progress.isCancelled()) {
        return;
      }
      const Index first = cells.start[c];
      const Index count = cells.start[c + 1] - first;
      Points inside(count, 3);
      for (Index i = 0; i < count; ++i) {
        inside.row(i) = points.row(cells.order[first + i]);
      }
      // Rounded along the row of cells, so that the shares add up.
      const auto upTo = [&](Index i) { return static_cast<Index>(ratio * static_cast<double>(i)); };
      const Index target = std::max<Index>(1, upTo(first + count) - upTo(first));
      // A cell whose points all lie in one place holds them all, however many.
      results[c] = rules.factor || count > fewPoints ? mergeClosestPairs(inside, target, {{}, rules.factor})
                                                     : mergeFewClosestPairs(inside, target);
      for (Index& place : results[c].places) {
        place = cells.order[first + place];
      }
    }
  });
  progress.throwIfCancelled();
  Index total = 0;
  for (const MergedPoints& result : results) {
    total += static_cast<Index>(result.places.size());
  }
  Decimated all{Points(total, 3), {}};
  std::vector<Index> places;
  for (const MergedPoints& result : results) {
    all.points.middleRows(static_cast<Index>(places.size()), result.points.rows()) = result.points;
    places.insert(places.end(), result.places.begin(), result.places.end());
  }
  all.groups = groupsAt(rules.groups, places);
  return all;
}

}  // namespace

MergedPoints mergeClosestPairs(const Points& points, Index target, const MergeRules& rules,
                               const Progress& progress) {
  constexpr std::size_t mergesToCheckpoint = 256;
  progress.throwIfCancelled();
  ClosestFirst closest(points, rules);
  std::vector<Merge> merges;
  while (closest.aliveCount() > std::max<Index>(target, 0) && closest.mergeOne(merges)) {
    if (merges.size() % mergesToCheckpoint == 0) {
      progress.throwIfCancelled();
    }
  }
  return closest.result(std::move(merges));
}

Decimated decimateInOctree(const Points& points, Index target, const MergeRules& rules,
                           const Progress& progress) {
  // Points near a cell's border find no partner beyond it, so no pass takes more than three in four.
  constexpr double leastRatio = 0.25;
  Decimated decimated{points, rules.groups};
  while (decimated.points.rows() > target) {
    const auto before = decimated.points.rows();
    const double ratio = std::max(leastRatio, static_cast<double>(target) / static_cast<double>(before));
    decimated = decimateCells(decimated.points, ratio, {decimated.groups, rules.factor}, progress);
    if (decimated.points.rows() > before - before / 16) {
      break;
    }
  }
  return decimated;
}

}  // namespace pbffd
