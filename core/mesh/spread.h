#pragma once

#include "core/base/types.h"

namespace pbffd {

/// How far from a plane, a line or a point a set of points spreads.
struct Spread {
  Vec3 center = Vec3::Zero();
  Mat3 axes = Mat3::Identity();    ///< the principal axes, right-handed, by ascending deviation
  Vec3 deviations = Vec3::Zero();  ///< standard deviations along them, in the points' units
};

/// Exact enough to tell flat sets apart wherever they lie: deviations to about 1e-15 of the greatest one.
Spread spreadAlongAxes(const Points& points);

/// The deviations, ascending, as shares of the largest one (which is 1, or 0 when all points are the same).
Vec3 spreadOf(const Points& points);

/// The share of the extent of the points below which a deviation may be made of nothing but rounding:
/// coordinates are rounded to 2^-53 of their size, and an offset eats into what is left of that.
double roundingShareOf(const Points& points);

/// Whether the points lie in a plane (or on a line, or in one point) as far as double precision can tell:
/// such points have no Voronoi vertices.
bool areCoplanar(const Points& points);

}  // namespace pbffd
