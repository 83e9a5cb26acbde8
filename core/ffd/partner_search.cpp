#include "core/ffd/partner_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace pbffd {
namespace {

constexpr Index leafSize = 8;

}  // namespace

struct PartnerSearch::Query {
  Index place;
  Vec3 from;
  Partner best;
  bool withFactor;  ///< or by distance alone

  /// Whether a partner at this squared distance, of this place or a higher one, could still be better.
  bool mayImprove(double squared, Index lowestPlace) const {
    return squared < best.cost || (squared == best.cost && lowestPlace < best.place);
  }
};

PartnerSearch::PartnerSearch(const Points& points, const MergeRules& rules)
    : rules_(rules),
      points_(points),
      leafOf_(static_cast<std::size_t>(points.rows()), 0),
      rootOf_(leafOf_.size(), 0),
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

double PartnerSearch::squaredDistance(const Node& node, const Vec3& from) const {
  // In the order in which squaredNorm() adds, so that a box is never farther than a point on its border.
  const Vec3 out = (node.low - from).cwiseMax(from - node.high).cwiseMax(0.0);
  return out.squaredNorm();
}

PartnerSearch::Partner PartnerSearch::best(Index place) const {
  Query query{place, point(place), {}, false};
  search(query);
  if (!rules_.factor || query.best.place < 0) {
    return query.best;
  }
  // Mostly the nearest one is not put back, and then nothing else needs to be asked for.
  if (rules_.factor(query.from, point(query.best.place)) == 1.0) {
    return query.best;
  }
  query = {place, query.from, {}, true};
  search(query);
  return query.best;
}

void PartnerSearch::search(Query& query) const {
  std::array<std::pair<Index, double>, 128> open;
  std::size_t size = 0;
  open[size++] = {rootOf_[query.place], 0.0};
  while (size > 0) {
    const auto [index, squared] = open[--size];
    const Node& node = nodes_[index];
    if (node.alive == 0 || !query.mayImprove(squared, node.lowestPlace)) {
      continue;
    }
    if (node.left < 0) {
      visitLeaf(node, query);
      continue;
    }
    const double left = squaredDistance(nodes_[node.left], query.from);
    const double right = squaredDistance(nodes_[node.left + 1], query.from);
    const bool leftFirst = left <= right;
    open[size++] = leftFirst ? std::pair(node.left + 1, right) : std::pair(node.left, left);
    open[size++] = leftFirst ? std::pair(node.left, left) : std::pair(node.left + 1, right);
  }
}

void PartnerSearch::visitLeaf(const Node& leaf, Query& query) const {
  for (Index i = leaf.begin; i < leaf.end; ++i) {
    const Index other = order_[i];
    if (other == query.place || !isAlive(other)) {
      continue;
    }
    const Vec3 at = point(other);
    const double squared = (at - query.from).squaredNorm();
    if (!query.mayImprove(squared, other)) {
      continue;
    }
    const double factor = query.withFactor ? rules_.factor(query.from, at) : 1.0;
    if (std::isfinite(factor) && query.mayImprove(squared * factor, other)) {
      query.best = {other, squared * factor};
    }
  }
}

void PartnerSearch::merge(Index kept, Index gone) {
  const Vec3 middle = 0.5 * (point(kept) + point(gone));
  points_.row(kept) = middle;
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
