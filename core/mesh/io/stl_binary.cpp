#include "core/mesh/io/stl_binary.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace pbffd::io {
namespace {

std::uint32_t littleEndian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    value = (value << 8) | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

/// Whether the file begins without what no text holds.
bool looksLikeText(std::string_view bytes) {
  // The number of facets and the floats behind it hold control characters soon.
  constexpr std::size_t looked = 512;
  return std::ranges::none_of(bytes.substr(0, looked), [](char c) {
    return (c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != '\v') || c == 127;
  });
}

}  // namespace

std::size_t stlFacetCount(std::string_view bytes) {
  return littleEndian(bytes.substr(80, 4));
}

bool isBinaryStl(std::string_view bytes) {
  if (bytes.size() >= stlHeaderBytes && bytes.size() - stlHeaderBytes == stlFacetBytes * stlFacetCount(bytes)) {
    return true;
  }
  return !looksLikeText(bytes);
}

std::string_view stlVector(std::string_view bytes, std::size_t facet, std::size_t which) {
  return bytes.substr(stlHeaderBytes + stlFacetBytes * facet + 12 * which, 12);
}

Vec3 decodeStlVector(std::string_view piece) {
  Vec3 vector;
  for (int axis = 0; axis < 3; ++axis) {
    vector[axis] = std::bit_cast<float>(littleEndian(piece.substr(4 * static_cast<std::size_t>(axis), 4)));
  }
  return vector;
}

std::string encodeStlVector(const Vec3& vector) {
  std::string bytes;
  for (int axis = 0; axis < 3; ++axis) {
    const auto word = std::bit_cast<std::uint32_t>(static_cast<float>(vector[axis]));
    for (int shift = 0; shift < 32; shift += 8) {
      bytes += static_cast<char>((word >> shift) & 0xFF);
    }
  }
  return bytes;
}

std::uint16_t stlAttribute(std::string_view bytes, std::size_t facet) {
  return static_cast<std::uint16_t>(
      littleEndian(bytes.substr(stlHeaderBytes + stlFacetBytes * facet + stlFacetBytes - 2, 2)));
}

}  // namespace pbffd::io
