#include "core/ffd/placement/partner_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pbffd {
namespace {

constexpr Index leafSize = 8;

bool isBetter(double cost, Index place, const PartnerSearch::Partner& than) {
  return cost < than.cost || (cost == than.cost && place < than.place);
}

/// Of a box, in the order in which squaredNorm() adds, so that no box is farther than a point on its border.
double squaredDistance(const Vec3& low, const Vec3& high, const Vec3& from) {
  const auto out = [&](int axis) { return std::max({low[axis] - from[axis], from[axis] - high[axis], 0.0}); };
  const Vec3 way(out(0), out(1), out(2));
  return way.squaredNorm();
}

}  // namespace

/// Looks for the nearest.
struct PartnerSearch::NearestQuery {
  Index place;
  Vec3 from;
  Partner found;

  /// Whether a partner at this squared distance, of this place or a higher one, would be taken.
  bool mayFind(double squared, Index lowestPlace) const { return isBetter(squared, lowestPlace, found); }
  void offer(double squared, Index other) {
    if (other != place && mayFind(squared, other)) {
      found = {other, squared};
    }
  }
};

/// Looks for the nearest few that come after a partner tried before and before a limit.
struct PartnerSearch::FewQuery {
  Index place;
  Vec3 from;
  std::size_t few;             ///< how many are looked for
  Partner after;               ///< found ones are farther than this
  Partner limit;               ///< ... and nearer than this
  std::vector<Partner> found;  ///< by distance, then place; the cost is the squared distance alone

  bool mayFind(double squared, Index lowestPlace) const {
    return isBetter(squared, lowestPlace, limit) &&
           (found.size() < few || isBetter(squared, lowestPlace, found.back()));
  }
  void offer(double squared, Index other) {
    if (other == place || !mayFind(squared, other) || !isBetter(after.cost, after.place, {other, squared})) {
      return;
    }
    if (found.size() == few) {
      found.pop_back();
    }
    const auto at = std::find_if(found.begin(), found.end(),
                                 [&](const Partner& one) { return isBetter(squared, other, one); });
    found.insert(at, {other, squared});
  }
};

PartnerSearch::PartnerSearch(const Points& points, const MergeRules& rules)
    : rules_(rules),
      points_(points),
      slotOf_(static_cast<std::size_t>(points.rows()), 0),
      leafOf_(slotOf_.size(), 0),
      rootOf_(leafOf_.size(), 0),
      versions_(leafOf_.size(), 0),
      known_(leafOf_.size()),
      alive_(static_cast<Index>(points.rows())) {
  build();
}

void PartnerSearch::build() {
  order_.clear();
  for (Index place = 0; place < static_cast<Index>(leafOf_.size()); ++place) {
    if (isAlive(place)) {
      order_.push_back(place);
    }
  }
  const auto& groups = rules_.groups;
  if (!groups.empty()) {
    std::stable_sort(order_.begin(), order_.end(), [&](Index a, Index b) { return groups[a] < groups[b]; });
  }
  nodes_.clear();
  builtWith_ = alive_;
  for (Index begin = 0, end; begin < alive_; begin = end) {
    end = alive_;
    if (!groups.empty()) {
      end = begin;
      while (end < alive_ && groups[order_[end]] == groups[order_[begin]]) {
        ++end;
      }
    }
    const Index root = addNode(begin, end, -1);
    for (Index i = begin; i < end; ++i) {
      rootOf_[order_[i]] = root;
    }
    split(root);
  }
  inSlots_.resize(alive_, 3);
  for (Index slot = 0; slot < alive_; ++slot) {
    slotOf_[order_[slot]] = slot;
    inSlots_.row(slot) = points_.row(order_[slot]);
  }
}

Index PartnerSearch::addNode(Index begin, Index end, Index parent) {
  Node node{Vec3::Constant(std::numeric_limits<double>::infinity()),
            Vec3::Constant(-std::numeric_limits<double>::infinity()),
            begin,
            end,
            parent,
            -1,
            order_[begin],
            end - begin};
  for (Index i = begin; i < end; ++i) {
    const Vec3 at = point(order_[i]);
    node.low = node.low.cwiseMin(at);
    node.high = node.high.cwiseMax(at);
    node.lowestPlace = std::min(node.lowestPlace, order_[i]);
  }
  nodes_.push_back(node);
  return static_cast<Index>(nodes_.size()) - 1;
}

void PartnerSearch::split(Index root) {
  std::vector<Index> open{root};
  while (!open.empty()) {
    const Index index = open.back();
    open.pop_back();
    const Node node = nodes_[index];
    if (node.end - node.begin <= leafSize) {
      for (Index i = node.begin; i < node.end; ++i) {
        leafOf_[order_[i]] = index;
      }
      continue;
    }
    int axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const Index middle = node.begin + (node.end - node.begin) / 2;
    std::nth_element(
        order_.begin() + node.begin, order_.begin() + middle, order_.begin() + node.end, [&](Index a, Index b) {
          return points_(a, axis) != points_(b, axis) ? points_(a, axis) < points_(b, axis) : a < b;
        });
    const Index left = addNode(node.begin, middle, index);
    addNode(middle, node.end, index);
    nodes_[index].left = left;
    open.push_back(left);
    open.push_back(left + 1);
  }
}

PartnerSearch::Partner PartnerSearch::nearest(Index place) const {
  NearestQuery query{place, point(place), {}};
  search(query);
  return query.found;
}

PartnerSearch::Partner PartnerSearch::best(Index place) {
  constexpr std::size_t most = 128;
  // Who has no partner among so many stands alone: with more parts than points all pairs may be forbidden.
  constexpr int mostForbidden = 64;
  int forbidden = 0;
  constexpr double nowhere = -1.0;
  FewQuery query{place, point(place), 1, {-1, nowhere}, {}, {}};
  // By distance, until the next one could not be the best whatever its factor; mostly the first one is.
  while (true) {
    query.found.clear();
    search(query);
    for (const Partner& partner : query.found) {
      if (!isBetter(partner.cost, partner.place, query.limit)) {
        return query.limit;
      }
      const double factor = factorOf(place, partner.place);
      const double cost = std::isfinite(factor) ? factor * partner.cost : factor;
      if (std::isfinite(factor) && isBetter(cost, partner.place, query.limit)) {
        query.limit = {partner.place, cost};
      }
      forbidden += std::isfinite(factor) ? 0 : 1;
      if (forbidden >= mostForbidden && query.limit.place < 0) {
        return query.limit;
      }
    }
    if (query.found.size() < query.few) {
      return query.limit;
    }
    query.after = query.found.back();
    query.few = std::min(most, 8 * query.few);
  }
}

double PartnerSearch::factorOf(Index place, Index other) {
  if (!rules_.factor) {
    return 1.0;
  }
  // The same from either end.
  const Index low = std::min(place, other);
  const Index high = std::max(place, other);
  for (const Known& known : known_[low]) {
    if (known.other == high && known.version == versions_[high]) {
      return known.factor;
    }
  }
  const double factor = rules_.factor(point(low), point(high));
  // What is not put back is found at once the next time; only the rest is worth keeping.
  if (factor != 1.0) {
    known_[low].push_back({high, versions_[high], factor});
  }
  return factor;
}

template <class Query>
void PartnerSearch::search(Query& query) const {
  std::array<std::pair<Index, double>, 128> open;
  std::size_t size = 0;
  open[size++] = {rootOf_[query.place], 0.0};
  while (size > 0) {
    const auto [index, squared] = open[--size];
    const Node& node = nodes_[index];
    if (node.alive == 0 || !query.mayFind(squared, node.lowestPlace)) {
      continue;
    }
    if (node.left < 0) {
      for (Index slot = node.begin; slot < node.end; ++slot) {
        query.offer((inSlots_.row(slot).transpose() - query.from).squaredNorm(), order_[slot]);
      }
      continue;
    }
    const Node& leftNode = nodes_[node.left];
    const Node& rightNode = nodes_[node.left + 1];
    const double left = squaredDistance(leftNode.low, leftNode.high, query.from);
    const double right = squaredDistance(rightNode.low, rightNode.high, query.from);
    const bool leftFirst = left <= right;
    open[size++] = leftFirst ? std::pair(node.left + 1, right) : std::pair(node.left, left);
    open[size++] = leftFirst ? std::pair(node.left, left) : std::pair(node.left + 1, right);
  }
}

void PartnerSearch::merge(Index kept, Index gone) {
  const Vec3 middle = 0.5 * (point(kept) + point(gone));
  points_.row(kept) = middle;
  inSlots_.row(slotOf_[kept]) = middle;
  inSlots_.row(slotOf_[gone]).setConstant(std::numeric_limits<double>::infinity());
  ++versions_[kept];
  known_[kept].clear();
  for (Index n = leafOf_[kept]; n >= 0; n = nodes_[n].parent) {
    nodes_[n].low = nodes_[n].low.cwiseMin(middle);
    nodes_[n].high = nodes_[n].high.cwiseMax(middle);
  }
  for (Index n = leafOf_[gone]; n >= 0; n = nodes_[n].parent) {
    --nodes_[n].alive;
  }
  leafOf_[gone] = -1;
  if (--alive_ < builtWith_ / 2 && alive_ > leafSize) {
    build();
  }
}

}  // namespace pbffd
