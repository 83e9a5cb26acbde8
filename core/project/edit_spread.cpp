#include "core/project/edit_spread.h"

#include "core/base/error.h"
#include "core/base/figures.h"
#include "core/base/text.h"
#include "core/project/mirror.h"

#include <algorithm>
#include <set>

namespace pbffd {
namespace {

void requireUsable(const Spread& spread, std::size_t points) {
  if (!spread.weights.empty() && spread.weights.size() != points) {
    throw InvalidInput(format("it has {} weights for {} points", spread.weights.size(), points));
  }
  for (const double weight : spread.weights) {
    requireFinite(weight, "a weight");
  }
  requireFinite(spread.plane, "the mirror plane");
}

/// Each axis once, in the order x, y, z.
std::vector<Axis> mirrorAxes(const Spread& spread) {
  const std::set<Axis> axes(spread.mirror.begin(), spread.mirror.end());
  return {axes.begin(), axes.end()};
}

class Partners {
 public:
  Partners(const Project& project, const Level& level, const Spread& spread) : axes_(mirrorAxes(spread)) {
    for (const Axis axis : axes_) {
      partners_.push_back(mirrorPartners(level, axis, mirrorCenter(project, spread)));
    }
  }

  /// The planes that a point lies on.
  std::vector<Axis> planesThrough(Index place) const {
    std::vector<Axis> planes;
    for (std::size_t k = 0; k < axes_.size(); ++k) {
      if (partners_[k][place] == place) {
        planes.push_back(axes_[k]);
      }
    }
    return planes;
  }

  /// The partners across each combination of the planes, each with that combination.
  std::vector<std::pair<Index, std::vector<Axis>>> of(Index place) const {
    std::vector<std::pair<Index, std::vector<Axis>>> found;
    for (unsigned combination = 1; combination < (1U << axes_.size()); ++combination) {
      Index partner = place;
      std::vector<Axis> planes;
      for (std::size_t k = 0; k < axes_.size() && partner >= 0; ++k) {
        if ((combination >> k & 1U) != 0) {
          partner = partners_[k][partner];
          planes.push_back(axes_[k]);
        }
      }
      if (partner >= 0) {
        found.emplace_back(partner, planes);
      }
    }
    return found;
  }

 private:
  std::vector<Axis> axes_;
  std::vector<std::vector<Index>> partners_;
};

}  // namespace

std::vector<Target> targetsOf(const EditScope& scope, const SelectedPlaces& selected, const Spread& spread) {
  const Project& project = scope.before;
  const Level& level = project.controls.levels[selected.level];
  requireUsable(spread, selected.places.size());
  const Partners partners(project, level, spread);
  std::vector<Target> targets;
  std::vector<bool> taken(level.size(), false);
  for (const Index place : selected.places) {
    taken[place] = true;
  }
  for (std::size_t entry = 0; entry < selected.places.size(); ++entry) {
    const Index place = selected.places[entry];
    const double weight = spread.weights.empty() ? 1.0 : spread.weights[entry];
    if (!level[place].locked) {
      targets.push_back({place, entry, weight, partners.planesThrough(place), {}});
    }
  }
  if (targets.empty()) {
    throw InvalidInput(selected.places.size() == 1 ? format("point {} is locked", level[selected.places[0]].id)
                                                   : std::string("all of its points are locked"));
  }
  const std::size_t named = targets.size();
  if (const std::size_t locked = selected.places.size() - named; locked > 0) {
    scope.remarks.push_back(format("{} of {} points {} locked and stayed in place.", counted(locked),
                                   counted(selected.places.size()), locked == 1 ? "is" : "are"));
  }
  std::size_t alone = 0;
  for (std::size_t k = 0; k < named; ++k) {
    const Target source = targets[k];
    const auto found = partners.of(source.place);
    alone += !spread.mirror.empty() && found.empty();
    for (const auto& [partner, planes] : found) {
      if (!taken[partner] && !level[partner].locked) {
        taken[partner] = true;
        targets.push_back({partner, source.entry, source.weight, source.onPlanes, planes});
      }
    }
  }
  if (alone > 0) {
    scope.remarks.push_back(format("{} of {} points {} no mirror partner, so nothing moved across from {}.",
                                   counted(alone), counted(named), alone == 1 ? "has" : "have",
                                   alone == 1 ? "it" : "them"));
  }
  return targets;
}

}  // namespace pbffd
