#pragma once

#include "core/ffd/control_point.h"
#include "core/mesh/mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace pbffd::test {

/// A task of the survey by Botsch and Sorkine (2008): a mesh, and the natural field that bends or twists it
/// evenly, known everywhere in space as a rigid map of each place.
struct Task {
  std::string name;
  Mesh mesh;
  /// The rigid motion of the matter around a place; the place itself goes to motion(x) x.
  std::function<AffineMap(const Vec3&)> motion;
};

/// A closed cylinder of 6,194 vertices whose free part is bent by 120 degrees in a plane.
Task bendTask();

/// A closed square bar of 6,194 vertices twisted by 135 degrees.
Task twistTask();

/// A trunk with a branch in the hollow of the bend, 4,760 vertices, bent by 70 degrees; the branch follows
/// rigidly.
Task cactusTask();

/// Where the natural field takes the points, N x 3.
Points naturalShape(const Task& task, const Points& points);

/// The points carried by the maps of the two held ends alone, blended evenly between: linear skinning.
Points blendedShape(const Task& task, const Points& points);

/// The points, of N x 3 in the rest shape, in the two ends that are held: ascending.
std::vector<Eigen::Index> handlesOf(const Points& points);

}  // namespace pbffd::test
