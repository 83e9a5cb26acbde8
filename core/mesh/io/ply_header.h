#pragma once

#include "core/mesh/io/input.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pbffd::io {

enum class PlyEncoding { ascii, littleEndian, bigEndian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a number of that type in a binary file.
std::size_t sizeOf(PlyType type);
bool isInteger(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> countType;  ///< of a list; nothing for a single number
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  /// The property of that name, or nothing.
  std::optional<std::size_t> find(std::string_view property) const;
};

/// What a PLY file says about itself before its data.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t bodyByte = 0;  ///< where the data begin
  std::size_t bodyLine = 0;  ///< and in which line, from 1

  const PlyElement* find(std::string_view element) const;
};

/// Throws InvalidInput that names the line.
PlyHeader parsePlyHeader(const Input& input);

}  // namespace pbffd::io
