#pragma once

#include "core/ffd/control_set.h"
#include "core/mesh/rest_mesh.h"

#include <memory>
#include <random>

namespace pbffd::test {

/// A control point with a sphere for its region.
inline ControlPoint pointAt(PointId id, const Vec3& center, double radius, Reach reach = Reach::connected) {
  ControlPoint point;
  point.id = id;
  point.reach = reach;
  point.rest = {center, radius * Mat3::Identity()};
  point.pose = point.rest;
  point.binding.at = center;
  return point;
}

/// A mesh and control points strewn over it by chance: turned ellipsoids, some of each reach, one disabled.
struct Scene {
  std::shared_ptr<const RestMesh> mesh;
  ControlSet set;
  std::mt19937 chance{7};

  double uniform(double low, double high) { return low + (high - low) * (chance() / 4294967296.0); }
  Vec3 vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }

  explicit Scene(Mesh shape, int points = 40, double radius = 0.3)
      : mesh(std::make_shared<RestMesh>(std::move(shape))) {
    const Bounds& bounds = mesh->bounds();
    const double size = mesh->diagonal();
    set.master.rest = {bounds.center(), 0.6 * size * Mat3::Identity()};
    set.master.pose = set.master.rest;
    for (int j = 0; j < points; ++j) {
      const auto vertex = static_cast<Index>(chance() % static_cast<unsigned>(mesh->vertexCount()));
      ControlPoint point = pointAt(j + 1, mesh->positions().row(vertex).transpose() + vector(0.02 * size), 1.0,
                                   j % 3 == 0 ? Reach::all : Reach::connected);
      const Mat3 turn = turnBy(vector(3.0));
      const Vec3 axes = radius * size * Vec3(uniform(0.5, 1), uniform(0.5, 1), uniform(0.5, 1));
      point.rest.axes = turn * axes.asDiagonal();
      point.pose = point.rest;
      point.strength = uniform(0.5, 2.0);
      point.enabled = j != 5;
      set.levels[0].append(point);
    }
  }

  /// A rotation about `axis` by its length in radians.
  static Mat3 turnBy(const Vec3& axis) {
    const double angle = axis.norm();
    Mat3 cross;
    cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
    cross /= angle;
    return Mat3::Identity() + std::sin(angle) * cross + (1.0 - std::cos(angle)) * cross * cross;
  }

  /// Moves, turns and stretches every other control point; the master too where asked for.
  void poseAtRandom(double amount = 0.05, bool withMaster = false) {
    for (Index j = 0; j < set.levels[0].size(); j += 2) {
      ControlPoint point = set.levels[0][j];
      point.pose = randomPose(point.rest, amount);
      set.levels[0].replace(j, point);
    }
    if (withMaster) {
      set.master.pose = randomPose(set.master.rest, amount);
    }
  }

  Frame randomPose(const Frame& rest, double amount) {
    const Mat3 bend =
        turnBy(vector(4.0 * amount)) + amount * (Mat3() << vector(1), vector(1), vector(1)).finished();
    return {rest.center + vector(amount * mesh->diagonal()), bend * rest.axes};
  }

  /// Every control point and the master under one map.
  void poseBy(const AffineMap& map) {
    for (Level& level : set.levels) {
      for (Index j = 0; j < level.size(); ++j) {
        ControlPoint point = level[j];
        point.pose = moved(point.rest, map);
        level.replace(j, point);
      }
    }
    set.master.pose = moved(set.master.rest, map);
  }
};

}  // namespace pbffd::test
