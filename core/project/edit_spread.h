#pragma once

#include "core/project/edit_scope.h"

#include <vector>

// How `move` and `transform` spread over points, mirror partners and the master; private to this folder.

namespace pbffd {

/// One point that an edit moves, and how the edit reaches it.
struct Target {
  Index place = 0;        ///< in its level
  std::size_t entry = 0;  ///< in the edit's list of points: whose motion it makes
  double weight = 1.0;
  /// Makes the motion one that the planes on which the point lies keep, before it is mirrored.
  std::vector<Axis> onPlanes;
  std::vector<Axis> mirrored;  ///< the planes that the motion is mirrored at
};

/// What the edit moves: the points of `where` that are not locked, then their mirror partners that are neither
/// named themselves nor locked. Remarks on those that stay for being locked, and on points without a partner.
/// Throws InvalidInput for weights that do not fit, and where all are locked.
std::vector<Target> targetsOf(const EditScope& scope, const SelectedPlaces& selected, const Spread& spread);

}  // namespace pbffd
