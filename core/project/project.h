#pragma once

#include "core/ffd/control_set.h"
#include "core/ffd/placement/placement.h"
#include "core/mesh/rest_mesh.h"

#include <memory>

namespace pbffd {

/// What a project file held that this program does not know, kept for the next save.
struct ForeignContent;

/// Everything that a project file holds: an immutable value whose parts are shared between copies. No
/// derived data: weights live in a WeightCache, what follows from the mesh in RestMesh.
struct Project {
  std::shared_ptr<const RestMesh> mesh;
  ControlSet controls;
  PlacementOptions placement;  ///< those of the last `place`
  PointId nextId = 1;          ///< the next free identifier
  std::shared_ptr<const ForeignContent> foreign;
};

/// Which parts of two values differ: what the views have to update.
struct ProjectChanges {
  bool mesh = false;
  bool structure = false;   ///< levels, points added or removed
  bool rest = false;        ///< weights follow: regions, strength, enabled, reach, basis, master's value
  bool poses = false;       ///< any pose, the master's included
  bool attributes = false;  ///< names, locks

  bool any() const { return mesh || structure || rest || poses || attributes; }
};
ProjectChanges changesBetween(const Project& before, const Project& after);

/// A project of a mesh alone: no control points, the master at rest.
Project projectOf(std::shared_ptr<const RestMesh> mesh);

}  // namespace pbffd
