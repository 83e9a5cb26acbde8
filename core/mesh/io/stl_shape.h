#pragma once

#include "core/mesh/io/reshaped.h"

#include <optional>

namespace pbffd::io {

/// The position of a vertex where it fits floats. Throws InvalidInput where it is too large.
Vec3 stlPosition(const Reshaped& shape, Index vertex);

/// The unit normal of three points; zero where they have no area.
Vec3 facetNormal(const Vec3& a, const Vec3& b, const Vec3& c);

/// What the normal of a facet becomes whose vertices moved: that of its new shape, on the side where it was.
/// Nothing where no vertex moved, where the source has a zero normal, and where the facet has no area.
std::optional<Vec3> movedFacetNormal(const Reshaped& shape, Index face);

}  // namespace pbffd::io
