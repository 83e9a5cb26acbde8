#pragma once

#include "core/base/types.h"

namespace pbffd {

/// What a deformation gradient F = d v' / d v does around a point.
struct Strain {
  Vec3 stretches;  ///< the principal stretches, longest first; 1 where nothing is stretched
  double volume;   ///< the volume after over before; negative where space is turned inside out
};
Strain strainOf(const Mat3& gradient);

/// A tangent carried along: F t. Its length is stretched with it.
Vec3 carriedTangent(const Mat3& gradient, const Vec3& tangent);

/// The unit normal of the deformed surface: the cofactors of F times the normal, which holds where F is
/// singular or mirrors too. Zero where the surface was crushed to a line or the normal was zero.
Vec3 carriedNormal(const Mat3& gradient, const Vec3& normal);

/// The rotation nearest to F: how a frame turns that must not be stretched.
Mat3 carriedRotation(const Mat3& gradient);

}  // namespace pbffd
