#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pbffd {

/// A partitioned VTK data set (.pvtu, .pvtp): an index file that names its pieces.
struct Partition {
  struct Piece {
    std::filesystem::path source;
    std::filesystem::path target;
    std::string targetName;  ///< as the new index names it
    std::size_t begin = 0;   ///< of its name in the text of the index
    std::size_t end = 0;
  };
  std::filesystem::path index;
  std::string text;
  std::vector<Piece> pieces;
};

constexpr std::array<std::string_view, 2> partitionEndings{".pvtu", ".pvtp"};

/// Whether the ending is that of a partitioned data set.
bool isPartition(const std::filesystem::path& path);

/// Reads the index; the deformed one will be `target`. Where both have one name the pieces keep theirs beside
/// it, otherwise the new pieces go to a folder named after the target. Throws IoError, or InvalidInput that
/// names the index and the piece: one that is missing, a name that stands twice.
Partition readPartition(const std::filesystem::path& index, const std::filesystem::path& target);

/// The text of the deformed index: the source's, with the pieces' new names.
std::string indexText(const Partition& partition);

/// "piece 3 of 8 (parts/c.vtu)".
std::string describePiece(const Partition& partition, std::size_t piece);

}  // namespace pbffd
