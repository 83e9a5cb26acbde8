#pragma once

#include "core/base/error.h"
#include "core/ffd/levels/hierarchy.h"
#include "core/project/edit.h"
#include "tests/support/shapes.h"

#include <cmath>
#include <memory>
#include <random>
#include <string>

namespace pbffd::test {

/// A project with spheres strewn over a mesh by chance: identifiers 1 to `points` on the finest level.
inline Project projectWith(int points = 40, int levels = 3, Mesh mesh = sphere()) {
  Project project;
  project.mesh = std::make_shared<const RestMesh>(std::move(mesh));
  project.controls.master.rest = {project.mesh->bounds().center(), project.mesh->diagonal() * Mat3::Identity()};
  project.controls.master.pose = project.controls.master.rest;
  std::mt19937 chance(5);
  Level finest;
  for (int i = 0; i < points; ++i) {
    ControlPoint point;
    point.id = project.nextId++;
    point.kind = i % 2 == 0 ? PointKind::interior : PointKind::exterior;
    const auto vertex = static_cast<Index>(chance() % static_cast<unsigned>(project.mesh->vertexCount()));
    const double inward = 0.7 + 0.5 * (chance() / 4294967296.0);
    const Vec3 center = project.mesh->bounds().center();
    point.rest.center = center + inward * (project.mesh->positions().row(vertex).transpose() - center);
    point.rest.axes = 0.25 * project.mesh->diagonal() * Mat3::Identity();
    point.pose = point.rest;
    finest.append(point);
  }
  project.controls.levels = buildLevels(finest, levels, project.nextId);
  return project;
}

/// The point with this identifier, wherever it is.
inline const ControlPoint& pointOf(const Project& project, PointId id) {
  for (const Level& level : project.controls.levels) {
    if (const auto place = level.find(id)) {
      return level[*place];
    }
  }
  throw InvalidInput("no such point");
}

inline EditResult resultOf(const Project& project, const Edit& edit) {
  EditWorkspace workspace;
  return apply(project, edit, workspace);
}

inline Project after(const Project& project, const Edit& edit) {
  return resultOf(project, edit).project;
}

/// The message with which an edit is refused; empty where it is not.
inline std::string refusal(const Project& project, const Edit& edit) {
  try {
    after(project, edit);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline double difference(const Frame& a, const Frame& b) {
  return std::max((a.center - b.center).cwiseAbs().maxCoeff(), (a.axes - b.axes).cwiseAbs().maxCoeff());
}

inline double difference(const AffineMap& a, const AffineMap& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

/// How far the levels are from what the contract says of them (section 4): each pose M x rest with
/// M = B x local, taken at the rest centre, over all levels.
inline double levelError(const Project& project) {
  const ControlSet& set = project.controls;
  const std::vector<PointWeights> bindings = levelBindings(*project.mesh, set);
  double worst = 0.0;
  for (std::size_t l = 1; l < set.levels.size(); ++l) {
    const LevelMaps maps = mapsOf(set, set.levels[l - 1]);
    for (Index i = 0; i < set.levels[l].size(); ++i) {
      const ControlPoint& point = set.levels[l][i];
      if (!(point.binding.at == point.rest.center)) {
        return INFINITY;
      }
      const AffineMap map = composed(blendedMap(bindings[l - 1], i, maps), point.binding.local);
      worst = std::max(worst, difference(moved(point.rest, map), point.pose));
    }
  }
  return worst;
}

}  // namespace pbffd::test
