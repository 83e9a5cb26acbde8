#include "core/ffd/hierarchy.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/ffd/frame_checks.h"

#include <algorithm>
#include <limits>

namespace pbffd {
namespace {

/// Points that are merged pair by pair, the closest pair first. Each point remembers its nearest neighbour,
/// so that a merge costs one pass over the points and a few searches.
class PairMerger {
 public:
  PairMerger(const Level& finer, RegionShape shape) : shape_(shape) {
    for (const ControlPoint& point : finer) {
      groups_.push_back({point.rest, {point.id}, point.reach == Reach::all});
    }
    nearest_.resize(groups_.size());
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      findNearest(i);
    }
    alive_ = groups_.size();
  }

  struct Group {
    Frame rest;
    std::vector<PointId> members;  ///< empty: merged into another
    bool reachesAll = false;       ///< whether every member does
  };

  std::size_t alive() const { return alive_; }
  const std::vector<Group>& groups() const { return groups_; }

  void mergeClosest() {
    std::size_t first = groups_.size();
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (isAlive(i) && (first == groups_.size() || nearest_[i].squared < nearest_[first].squared)) {
        first = i;
      }
    }
    // The lowest place of the closest pair was found first, so its partner lies behind it.
    const std::size_t second = nearest_[first].place;
    Group& kept = groups_[first];
    Group& gone = groups_[second];
    kept.rest = enclosingRegion(kept.rest, gone.rest, shape_);
    kept.members.insert(kept.members.end(), gone.members.begin(), gone.members.end());
    kept.reachesAll = kept.reachesAll && gone.reachesAll;
    gone.members.clear();
    --alive_;
    refreshNeighbours(first, second);
  }

 private:
  struct Nearest {
    double squared = std::numeric_limits<double>::infinity();
    std::size_t place = 0;
  };

  bool isAlive(std::size_t i) const { return !groups_[i].members.empty(); }

  double squaredDistance(std::size_t i, std::size_t j) const {
    return (groups_[i].rest.center - groups_[j].rest.center).squaredNorm();
  }

  void findNearest(std::size_t i) {
    nearest_[i] = {};
    for (std::size_t j = 0; j < groups_.size(); ++j) {
      if (j != i && isAlive(j) && squaredDistance(i, j) < nearest_[i].squared) {
        nearest_[i] = {squaredDistance(i, j), j};
      }
    }
  }

  void refreshNeighbours(std::size_t merged, std::size_t gone) {
    findNearest(merged);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (i == merged || !isAlive(i)) {
        continue;
      }
      if (nearest_[i].place == merged || nearest_[i].place == gone) {
        findNearest(i);
        continue;
      }
      const double squared = squaredDistance(i, merged);
      if (squared < nearest_[i].squared || (squared == nearest_[i].squared && merged < nearest_[i].place)) {
        nearest_[i] = {squared, merged};
      }
    }
  }

  RegionShape shape_;
  std::vector<Group> groups_;
  std::vector<Nearest> nearest_;
  std::size_t alive_ = 0;
};

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
  PairMerger merger(finer, shape);
  while (merger.alive() > static_cast<std::size_t>(finer.size() / 2)) {
    merger.mergeClosest();
  }
  Level level;
  for (const PairMerger::Group& group : merger.groups()) {
    if (group.members.empty()) {
      continue;
    }
    ControlPoint point;
    point.id = nextId++;
    point.kind = PointKind::merged;
    point.reach = group.reachesAll ? Reach::all : Reach::connected;
    point.rest = group.rest;
    point.pose = group.rest;
    point.mergedFrom = group.members;
    std::sort(point.mergedFrom.begin(), point.mergedFrom.end());
    level.append(std::move(point));
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
    const Level& finer = set.levels[l];
    Points at(finer.size(), 3);
    for (Index i = 0; i < finer.size(); ++i) {
      at.row(i) = finer[i].binding.at;
    }
    bindings.push_back(weightsAt(at, mesh, set.basis, set.master, set.levels[l - 1], progress));
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
        point.pose = moved(point.rest, composed(blendedMap(weights, i, maps), point.binding.local));
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
    Binding binding{point.rest.center, point.binding.local};
    // A binding that gives the pose to the last bit stays, so that nothing drifts.
    if (!(moved(point.rest, composed(blend, binding.local)) == point.pose)) {
      if (!isInvertible(blend.leftCols<3>())) {
        throw InvalidInput(format(
            "point {} cannot hang on level {}, which is flattened there; turn or stretch that level less",
            point.id, level));
      }
      binding.local = composed(inverted(blend), point.map());
    }
    if (!(binding == point.binding)) {
      ControlPoint bound = point;
      bound.binding = binding;
      finer.replace(i, std::move(bound));
    }
  }
}

}  // namespace pbffd
