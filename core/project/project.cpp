#include "core/project/project.h"

#include <algorithm>

namespace pbffd {
namespace {

bool sameRest(const ControlPoint& a, const ControlPoint& b) {
  return a.rest == b.rest && a.enabled == b.enabled && a.strength == b.strength && a.reach == b.reach;
}

bool sameAttributes(const ControlPoint& a, const ControlPoint& b) {
  return a.name == b.name && a.locked == b.locked && a.kind == b.kind && a.mergedFrom == b.mergedFrom;
}

bool sameIdentifiers(const Level& a, const Level& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ControlPoint& p, const ControlPoint& q) { return p.id == q.id; });
}

void compareLevels(const Level& before, const Level& after, ProjectChanges& changes) {
  for (Index i = 0; i < after.size(); ++i) {
    if (after.shares(i, before)) {
      continue;
    }
    const ControlPoint& a = before[i];
    const ControlPoint& b = after[i];
    changes.rest = changes.rest || !sameRest(a, b);
    changes.poses = changes.poses || !(a.pose == b.pose) || !(a.binding == b.binding);
    changes.attributes = changes.attributes || !sameAttributes(a, b);
  }
}

}  // namespace

ProjectChanges changesBetween(const Project& before, const Project& after) {
  const ControlSet& a = before.controls;
  const ControlSet& b = after.controls;
  ProjectChanges changes;
  changes.mesh = before.mesh != after.mesh;
  changes.structure =
      !std::equal(a.levels.begin(), a.levels.end(), b.levels.begin(), b.levels.end(), sameIdentifiers);
  changes.rest = !(a.basis == b.basis) || a.master.value != b.master.value || a.master.mode != b.master.mode ||
                 !(a.master.rest == b.master.rest);
  changes.poses = !(a.master.pose == b.master.pose);
  changes.attributes = !(before.placement == after.placement);
  if (changes.structure) {
    changes.rest = changes.poses = changes.attributes = true;
    return changes;
  }
  for (std::size_t l = 0; l < b.levels.size(); ++l) {
    compareLevels(a.levels[l], b.levels[l], changes);
  }
  return changes;
}

Project projectOf(std::shared_ptr<const RestMesh> mesh) {
  Project project;
  const PlacementOptions defaults;
  project.controls.master = makeMaster(*mesh, defaults.master, defaults.masterMode);
  project.mesh = std::move(mesh);
  return project;
}

}  // namespace pbffd
