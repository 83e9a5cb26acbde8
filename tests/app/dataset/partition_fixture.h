#pragma once

#include <filesystem>

namespace pbffd::test {

/// How many points two neighbouring pieces of writePartition() share: the last of one, the first of the next.
constexpr int sharedPoints = 49;

/// An index and, in a folder of its name, the pieces 0.vtu, 1.vtu, ...: slabs of hexahedra, side by side along
/// z, in double precision, with the point array "velocity".
void writePartition(const std::filesystem::path& index, int pieces);

/// A piece of triangles alone, in single precision.
void writeSurfacePiece(const std::filesystem::path& path);

/// A piece without points.
void writeEmptyPiece(const std::filesystem::path& path);

}  // namespace pbffd::test
