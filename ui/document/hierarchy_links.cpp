#include "ui/document/hierarchy_links.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <unordered_map>
#include <unordered_set>

namespace pbffd::ui {
namespace {

using Ids = std::unordered_set<PointId>;
using Wanted = std::function<bool(PointId parent, PointId child)>;

/// The links between a level (from 0) and the next finer one, by the order of the parents.
std::vector<HierarchyLink> linksBelow(const ControlSet& set, Index level, const Wanted& isWanted) {
  std::vector<HierarchyLink> links;
  if (level < 0 || level + 1 >= static_cast<Index>(set.levels.size())) {
    return links;
  }
  const Level& coarser = set.levels[static_cast<std::size_t>(level)];
  const Level& finer = set.levels[static_cast<std::size_t>(level) + 1];
  std::unordered_map<PointId, Index> places;
  for (Index i = 0; i < finer.size(); ++i) {
    places.emplace(finer[i].id, i);
  }
  for (Index i = 0; i < coarser.size(); ++i) {
    for (const PointId child : coarser[i].mergedFrom) {
      const auto at = places.find(child);
      if (at != places.end() && isWanted(coarser[i].id, child)) {
        links.push_back({level, i, at->second});
      }
    }
  }
  return links;
}

const ControlPoint& parentOf(const ControlSet& set, const HierarchyLink& link) {
  return set.levels[static_cast<std::size_t>(link.level)][link.parent];
}

const ControlPoint& childOf(const ControlSet& set, const HierarchyLink& link) {
  return set.levels[static_cast<std::size_t>(link.level) + 1][link.child];
}

std::vector<HierarchyLink> linksToChildren(const ControlSet& set, Index level, const Ids& parents) {
  return linksBelow(set, level, [&](PointId parent, PointId) { return parents.contains(parent); });
}

std::vector<HierarchyLink> linksToParents(const ControlSet& set, Index level, const Ids& children) {
  return linksBelow(set, level - 1, [&](PointId, PointId child) { return children.contains(child); });
}

}  // namespace

std::vector<HierarchyLink> hierarchyLinks(const ControlSet& set) {
  std::vector<HierarchyLink> all;
  for (Index level = 0; level + 1 < static_cast<Index>(set.levels.size()); ++level) {
    std::ranges::copy(linksBelow(set, level, [](PointId, PointId) { return true; }), std::back_inserter(all));
  }
  return all;
}

std::vector<HierarchyLink> hierarchyLinks(const ControlSet& set, int level,
                                          const std::vector<PointId>& points) {
  std::vector<HierarchyLink> all;
  Ids upper(points.begin(), points.end());
  for (Index at = level - 1; at > 0 && !upper.empty(); --at) {
    const auto links = linksToParents(set, at, upper);
    all.insert(all.begin(), links.begin(), links.end());
    upper.clear();
    std::ranges::for_each(links, [&](const HierarchyLink& link) { upper.insert(parentOf(set, link).id); });
  }
  Ids lower(points.begin(), points.end());
  for (Index at = level - 1; at < static_cast<Index>(set.levels.size()) && !lower.empty(); ++at) {
    const auto links = linksToChildren(set, at, lower);
    all.insert(all.end(), links.begin(), links.end());
    lower.clear();
    std::ranges::for_each(links, [&](const HierarchyLink& link) { lower.insert(childOf(set, link).id); });
  }
  return all;
}

std::vector<PointId> childrenOf(const ControlSet& set, int level, const std::vector<PointId>& points) {
  std::vector<PointId> children;
  for (const HierarchyLink& link : linksToChildren(set, level - 1, {points.begin(), points.end()})) {
    children.push_back(childOf(set, link).id);
  }
  return children;
}

std::vector<PointId> parentsOf(const ControlSet& set, int level, const std::vector<PointId>& points) {
  std::vector<PointId> parents;
  for (const HierarchyLink& link : linksToParents(set, level - 1, {points.begin(), points.end()})) {
    if (const PointId parent = parentOf(set, link).id; parents.empty() || parents.back() != parent) {
      parents.push_back(parent);
    }
  }
  return parents;
}

}  // namespace pbffd::ui
