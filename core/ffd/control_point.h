#pragma once

#include "core/base/affine.h"
#include "core/base/types.h"

#include <string>
#include <vector>

namespace pbffd {

/// A point with three axes: the reference frame of a control point (McDonnell & Qin, 3.1).
struct Frame {
  Vec3 center = Vec3::Zero();
  Mat3 axes = Mat3::Identity();  ///< columns a, b, c

  bool operator==(const Frame&) const = default;
};

/// M = pose x inverse(rest): the map that carries a rest frame to its pose. Rest axes are orthogonal.
AffineMap mapBetween(const Frame& rest, const Frame& pose);

/// The frame after `map`: its centre and axes moved along.
Frame moved(const Frame& frame, const AffineMap& map);

enum class PointKind { interior, exterior, manual, merged, curve };

/// Which vertices of its region a control point moves (contract, section 4).
enum class Reach { connected, all };

/// How a point of a finer level hangs on the next coarser one (contract, section 4): its map is B x local,
/// B the blend of the coarser level's maps at `at`.
struct Binding {
  Vec3 at = Vec3::Zero();  ///< the rest centre that B is taken at
  AffineMap local = identityMap();

  bool operator==(const Binding&) const = default;
};

/// A control point: the rest frame is its region of influence (the axes are the semi-axes of the
/// ellipsoid), the pose is where the user took it.
struct ControlPoint {
  PointId id = 0;
  std::string name;
  PointKind kind = PointKind::manual;
  bool enabled = true;
  bool locked = false;
  double strength = 1.0;  ///< multiplies the basis value; > 0
  Reach reach = Reach::connected;
  Frame rest;
  Frame pose;
  /// The points of the next finer level that it stands for, ascending: one that was taken over as it was,
  /// two that were merged, or more where merged points merged again. Empty for a point made otherwise.
  std::vector<PointId> mergedFrom;
  Binding binding;  ///< unused on the coarsest level

  AffineMap map() const { return mapBetween(rest, pose); }
  bool operator==(const ControlPoint&) const = default;
};

}  // namespace pbffd
