#include "core/mesh/io/stl_shape.h"

#include "core/base/text.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <span>

namespace pbffd::io {

Vec3 stlPosition(const Reshaped& shape, Index vertex) {
  const Vec3 position = shape.position(vertex);
  if (position.cwiseAbs().maxCoeff() > std::numeric_limits<float>::max()) {
    shape.fail(format("Vertex {} lies too far away for the numbers of an STL file", vertex),
               "Scale the mesh down, or export to another file format.");
  }
  return position;
}

Vec3 facetNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a).stableNormalized();
}

std::optional<Vec3> movedFacetNormal(const Reshaped& shape, Index face) {
  const std::span<const Index> corners = shape.mesh().faces[face];
  const auto normals = std::ranges::find(shape.mesh().attributes, "normal", &Attribute::name);
  if (normals == shape.mesh().attributes.end()) {
    return std::nullopt;
  }
  const Vec3 source(normals->values.data() + 3 * static_cast<std::size_t>(face));
  const bool isMoved = std::ranges::any_of(corners, [&](Index vertex) { return shape.isMoved(vertex); });
  if (!isMoved || source.isZero(0.0)) {
    return std::nullopt;
  }
  const Points& rest = shape.mesh().positions;
  const Vec3 before = facetNormal(rest.row(corners[0]), rest.row(corners[1]), rest.row(corners[2]));
  const Vec3 after =
      facetNormal(shape.position(corners[0]), shape.position(corners[1]), shape.position(corners[2]));
  if (after.isZero(0.0)) {
    return std::nullopt;
  }
  return before.dot(source) < 0.0 ? Vec3(-after) : after;
}

}  // namespace pbffd::io
