#pragma once

#include "core/base/progress.h"
#include "core/ffd/control_set.h"
#include "core/mesh/rest_mesh.h"

#include <vector>

namespace pbffd {

/// What `reach` leaves of one region, in a form that any vertex can be asked about later, without the walk
/// that found it (contract, section 4).
class RegionCut {
 public:
  /// Everything counts.
  RegionCut() = default;
  /// component: of the vertex nearest to the centre; cut: the representatives of this component that lie
  /// inside the region without being joined to that vertex there, ascending.
  RegionCut(Index component, std::vector<Index> cut) : component_(component), cut_(std::move(cut)) {}

  bool isWhole() const { return component_ < 0; }

  /// Whether the vertex counts, as ReachWalk::counts() says it.
  bool counts(Index vertex, const RestMesh& mesh, const Region& region) const;

 private:
  Index component_ = -1;
  std::vector<Index> cut_;
};

/// One a control point of the level; whole for those that reach all, hold no vertex or are disabled.
/// Throws Cancelled.
std::vector<RegionCut> regionCuts(const RestMesh& mesh, const Level& level, const Progress& progress = {});

}  // namespace pbffd
