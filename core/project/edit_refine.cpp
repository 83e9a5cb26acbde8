#include "core/base/error.h"
#include "core/base/figures.h"
#include "core/base/text.h"
#include "core/ffd/refinement/refinement.h"
#include "core/project/edit_functions.h"

#include <algorithm>
#include <map>
#include <set>

namespace pbffd {
namespace {

constexpr int leastFactor = 2;
constexpr int greatestFactor = 64;
/// As many as `place` allows.
constexpr std::size_t mostPoints = 20000;

/// Those of the points whose regions can be refined. A disabled point shapes nothing, a curve makes its own
/// points.
std::vector<Index> refinable(const EditScope& scope, const Level& level, const std::vector<Index>& places) {
  std::vector<Index> usable;
  std::copy_if(places.begin(), places.end(), std::back_inserter(usable),
               [&](Index place) { return level[place].enabled && level[place].kind != PointKind::curve; });
  if (usable.empty()) {
    const ControlPoint& first = level[places.front()];
    throw InvalidInput(first.enabled
                           ? format("point {} is of a curve; give the curve more points instead", first.id)
                           : format("point {} is disabled; enable it first", first.id));
  }
  if (const std::size_t left = places.size() - usable.size(); left > 0) {
    scope.remarks.push_back(format("{} of the points {} disabled or of a curve and {} not refined.",
                                   counted(left), left == 1 ? "is" : "are", left == 1 ? "was" : "were"));
  }
  return usable;
}

std::string pointWords(const Level& level, const std::vector<Index>& places) {
  return places.size() == 1 ? format("the region of point {}", level[places[0]].id)
                            : format("the regions of these {} points", counted(places.size()));
}

Refinement refined(const EditScope& scope, const Level& level, const std::vector<Index>& places, int factor) {
  const ControlSet& before = scope.before.controls;
  const ControlSet alone{before.basis, before.master, {level}};
  const std::size_t wanted = places.size() * static_cast<std::size_t>(factor - 1);
  if (const std::size_t total = static_cast<std::size_t>(level.size()) + wanted; total > mostPoints) {
    throw InvalidInput(
        format("it would make {} points of one level, more than {}; refine fewer points or by a "
               "smaller factor",
               counted(total), counted(mostPoints)));
  }
  Refinement refinement = refinedPoints(scope.before.mesh, alone, places, {scope.before.placement, factor},
                                        scope.progress, scope.workspace.placement);
  scope.workspace.placement = refinement.cache;
  if (refinement.points.empty()) {
    throw InvalidInput(
        format("there is no room for more points in {}: nothing that placement could take stands apart "
               "there. Make the region larger, refine its neighbours, or add points by hand",
               pointWords(level, places)));
  }
  if (refinement.points.size() < wanted) {
    scope.remarks.push_back(format("{} of {} points were added: there is no room for more in {}.",
                                   counted(refinement.points.size()), counted(wanted),
                                   pointWords(level, places)));
  }
  return refinement;
}

/// "Neck 2" beside "Neck"; nothing beside a point without a name.
std::string nameBeside(const std::string& name, std::set<std::string>& inUse) {
  if (name.empty()) {
    return {};
  }
  for (int number = 2;; ++number) {
    const std::string candidate = format("{} {}", name, number);
    if (inUse.insert(candidate).second) {
      return candidate;
    }
  }
}

/// The points that refine one, under names and identifiers of their own.
using Families = std::map<Index, std::vector<ControlPoint>>;
Families familiesOf(const Level& level, Refinement refinement, PointId& nextId) {
  std::set<std::string> names;
  for (const ControlPoint& point : level) {
    names.insert(point.name);
  }
  Families families;
  for (RefinedPoint& made : refinement.points) {
    made.point.id = nextId++;
    made.point.name = nameBeside(level[made.refines].name, names);
    families[made.refines].push_back(std::move(made.point));
  }
  return families;
}

/// What stands for a refined point stands for the points that refine it as well.
void addToParents(Level& coarser, const Level& level, const Families& families) {
  std::map<PointId, const std::vector<ControlPoint>*> refining;
  for (const auto& [place, family] : families) {
    refining.emplace(level[place].id, &family);
  }
  for (Index i = 0; i < coarser.size(); ++i) {
    ControlPoint parent = coarser[i];
    for (const PointId member : coarser[i].mergedFrom) {
      if (const auto found = refining.find(member); found != refining.end()) {
        for (const ControlPoint& made : *found->second) {
          parent.mergedFrom.push_back(made.id);
        }
      }
    }
    if (parent.mergedFrom.size() != coarser[i].mergedFrom.size()) {
      std::sort(parent.mergedFrom.begin(), parent.mergedFrom.end());
      coarser.replace(i, std::move(parent));
    }
  }
}

/// Each finer point that a refined one stood for goes to the nearest of it and those that refine it.
void shareChildren(ControlPoint& refined, std::vector<ControlPoint>& family, const Level& finer) {
  std::vector<PointId> kept;
  for (const PointId child : refined.mergedFrom) {
    const auto place = finer.find(child);
    const Vec3 at = place ? finer[*place].rest.center : refined.rest.center;
    ControlPoint* nearest = &refined;
    for (ControlPoint& made : family) {
      if ((made.rest.center - at).squaredNorm() < (nearest->rest.center - at).squaredNorm()) {
        nearest = &made;
      }
    }
    (nearest == &refined ? kept : nearest->mergedFrom).push_back(child);
  }
  refined.mergedFrom = std::move(kept);
}

}  // namespace

Project applied(const EditScope& scope, const Refine& edit) {
  if (edit.factor < leastFactor || edit.factor > greatestFactor) {
    throw InvalidInput(
        format("the factor is {}; it must be {} to {}", edit.factor, leastFactor, greatestFactor));
  }
  Project after = scope.before;
  ControlSet edited = scope.before.controls;
  const SelectedPlaces selected = selectedPlaces(edited, edit.where);
  Level& level = edited.levels[selected.level];
  const std::vector<Index> places = refinable(scope, level, selected.places);
  Families families = familiesOf(level, refined(scope, level, places, edit.factor), after.nextId);
  if (selected.level > 0) {
    addToParents(edited.levels[selected.level - 1], level, families);
  }
  const bool hasFiner = selected.level + 1 < static_cast<Index>(edited.levels.size());
  for (auto& [place, family] : families) {
    if (ControlPoint point = level[place]; hasFiner && !point.mergedFrom.empty()) {
      shareChildren(point, family, edited.levels[selected.level + 1]);
      level.replace(place, std::move(point));
    }
  }
  for (const Index place : places) {
    for (ControlPoint& made : families[place]) {
      level.append(std::move(made));
    }
  }
  after.controls = withStructure(scope, std::move(edited)).controls;
  return after;
}

}  // namespace pbffd
