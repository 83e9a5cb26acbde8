#pragma once

#include "core/base/types.h"
#include "core/mesh/io/input.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pbffd::io {

// Binary STL: 80 bytes of anything, the number of facets in 4, then 50 a facet: the normal, three vertices
// (three floats each), and two bytes that programs use as they like. All of it little-endian.
inline constexpr std::size_t stlHeaderBytes = 84;
inline constexpr std::size_t stlFacetBytes = 50;

/// Whether the bytes are binary STL. Many binary files begin with "solid" as text files do, so that the
/// number of facets is compared with the size, and a text holds no control characters.
bool isBinaryStl(std::string_view bytes);

/// The number of facets that the header promises.
std::size_t stlFacetCount(std::string_view bytes);

/// The piece that holds vector `which` of a facet: 0 its normal, 1 to 3 its vertices.
std::string_view stlVector(std::string_view bytes, std::size_t facet, std::size_t which);
Vec3 decodeStlVector(std::string_view piece);
std::string encodeStlVector(const Vec3& vector);

std::uint16_t stlAttribute(std::string_view bytes, std::size_t facet);

}  // namespace pbffd::io
