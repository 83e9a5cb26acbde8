#pragma once

#include "core/base/affine.h"
#include "core/mesh/mesh.h"

#include <cmath>

namespace pbffd::test {

/// What bending a shape along the x axis into an arc does next to a place: the turn of its cross-section. A
/// shape with these bounds is bent towards y by `degrees` from its one end to the other.
inline AffineMap bendAt(const Vec3& place, const Bounds& bounds, double degrees) {
  const double length = bounds.high.x() - bounds.low.x();
  const double total = degrees * M_PI / 180.0;
  const double angle = total * (place.x() - bounds.low.x()) / length;
  const double radius = length / total;
  Mat3 turn = Mat3::Identity();
  turn.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const double middle = bounds.center().y();
  const Vec3 from(place.x(), middle, 0.0);
  const Vec3 to(bounds.low.x() + radius * std::sin(angle), middle + radius * (1.0 - std::cos(angle)), 0.0);
  return makeMap(turn, to - turn * from);
}

}  // namespace pbffd::test
