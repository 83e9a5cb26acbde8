#include "core/ffd/levels/hierarchy.h"

#include "core/base/parallel.h"
#include "core/ffd/levels/binding.h"
#include "core/ffd/placement/decimation.h"
#include "core/ffd/rest_centres.h"

#include <algorithm>
#include <numeric>

namespace pbffd {
namespace {

/// A point of the coarser level in the making.
struct Group {
  Frame rest;
  std::vector<PointId> members;  ///< of the finer level
  bool reachesAll = false;       ///< whether every member does
};

void absorb(Group& kept, const Group& gone, RegionShape shape) {
  kept.rest = enclosingRegion(kept.rest, gone.rest, shape);
  kept.members.insert(kept.members.end(), gone.members.begin(), gone.members.end());
  kept.reachesAll = kept.reachesAll && gone.reachesAll;
}

/// The merges that each point is the outcome of, in their order; empty for points that are gone.
std::vector<std::vector<Merge>> mergesByOutcome(const std::vector<Merge>& merges, std::size_t points) {
  std::vector<Index> outcome(points);
  std::iota(outcome.begin(), outcome.end(), 0);
  std::for_each(merges.rbegin(), merges.rend(),
                [&](const Merge& merge) { outcome[merge.gone] = outcome[merge.kept]; });
  std::vector<std::vector<Merge>> byOutcome(points);
  for (const Merge& merge : merges) {
    byOutcome[outcome[merge.kept]].push_back(merge);
  }
  return byOutcome;
}

ControlPoint mergedPoint(PointId id, Group group) {
  ControlPoint point;
  point.id = id;
  point.kind = PointKind::merged;
  point.reach = group.reachesAll ? Reach::all : Reach::connected;
  point.rest = group.rest;
  point.pose = group.rest;
  point.mergedFrom = std::move(group.members);
  std::sort(point.mergedFrom.begin(), point.mergedFrom.end());
  return point;
}

void bindAtRest(Level& level) {
  for (Index i = 0; i < level.size(); ++i) {
    ControlPoint point = level[i];
    point.binding = {point.rest.center, identityMap()};
    level.replace(i, std::move(point));
  }
}

/// Whether a blend by row `row` may differ: one of the points or the master that it is made of changed.
bool hangsOnChanged(const PointWeights& weights, Index row, const std::vector<bool>& changed,
                    bool masterChanged) {
  if (masterChanged && weights.master[row] != 0.0) {
    return true;
  }
  return std::any_of(weights.points.begin() + weights.start[row],
                     weights.points.begin() + weights.start[row + 1],
                     [&](Index place) { return changed[place]; });
}

std::vector<bool> changedPoses(const Level& before, const Level& after) {
  std::vector<bool> changed(after.size());
  for (Index i = 0; i < after.size(); ++i) {
    changed[i] = !after.shares(i, before) && !(after[i].pose == before[i].pose);
  }
  return changed;
}

}  // namespace

int greatestLevelCount(Index finestCount) {
  int count = 0;
  for (; finestCount > 0; finestCount /= 2) {
    ++count;
  }
  return std::max(count, 1);
}

Level coarserLevel(const Level& finer, PointId& nextId, RegionShape shape) {
  std::vector<Group> groups;
  for (const ControlPoint& point : finer) {
    groups.push_back({point.rest, {point.id}, point.reach == Reach::all});
  }
  const MergedPoints merged = mergeClosestPairs(restCentres(finer), finer.size() / 2);
  const auto merges = mergesByOutcome(merged.merges, groups.size());
  constexpr std::size_t grain = 8;
  parallelFor(merges.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      for (const Merge& merge : merges[i]) {
        absorb(groups[merge.kept], groups[merge.gone], shape);
      }
    }
  });
  Level level;
  for (const Index place : merged.places) {
    level.append(mergedPoint(nextId++, std::move(groups[place])));
  }
  return level;
}

std::vector<Level> buildLevels(const Level& finest, int levelCount, PointId& nextId, RegionShape shape) {
  const int count = std::max(1, std::min(levelCount, greatestLevelCount(finest.size())));
  std::vector<Level> levels(static_cast<std::size_t>(count));
  levels.back() = finest;
  for (std::size_t l = levels.size() - 1; l > 0; --l) {
    levels[l - 1] = coarserLevel(levels[l], nextId, shape);
    bindAtRest(levels[l]);
  }
  return levels;
}

std::vector<PointWeights> levelBindings(const RestMesh& mesh, const ControlSet& set, const Progress& progress) {
  std::vector<PointWeights> bindings;
  for (std::size_t l = 1; l < set.levels.size(); ++l) {
    bindings.push_back(bindingWeights(mesh, set, static_cast<Index>(l), progress));
  }
  return bindings;
}

void carryDown(const ControlSet& before, ControlSet& set, Index level,
               const std::vector<PointWeights>& bindings) {
  const bool masterChanged = !(set.master.pose == before.master.pose);
  for (std::size_t l = level + 1; l < set.levels.size(); ++l) {
    const PointWeights& weights = bindings[l - 1];
    const std::vector<bool> changed = changedPoses(before.levels[l - 1], set.levels[l - 1]);
    const LevelMaps maps = mapsOf(set, set.levels[l - 1]);
    Level& finer = set.levels[l];
    for (Index i = 0; i < finer.size(); ++i) {
      if (hangsOnChanged(weights, i, changed, masterChanged)) {
        ControlPoint point = finer[i];
        point.pose = boundPose(point, blendedMap(weights, i, maps));
        finer.replace(i, std::move(point));
      }
    }
  }
}

void rebind(ControlSet& set, Index level, const std::vector<PointWeights>& bindings) {
  if (level == 0) {
    return;
  }
  const PointWeights& weights = bindings[level - 1];
  const LevelMaps maps = mapsOf(set, set.levels[level - 1]);
  Level& finer = set.levels[level];
  for (Index i = 0; i < finer.size(); ++i) {
    const ControlPoint& point = finer[i];
    const AffineMap blend = blendedMap(weights, i, maps);
    // A binding that gives the pose to the last bit stays, so that nothing drifts.
    const Binding binding = boundPose(point, blend) == point.pose
                                ? Binding{point.rest.center, point.binding.local}
                                : bindingTo(point, blend, level - 1);
    if (!(binding == point.binding)) {
      ControlPoint bound = point;
      bound.binding = binding;
      finer.replace(i, std::move(bound));
    }
  }
}

}  // namespace pbffd
