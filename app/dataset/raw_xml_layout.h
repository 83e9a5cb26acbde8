#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pbffd {

/// An array of a VTK XML file whose numbers lie in the file as they are in memory.
struct RawArray {
  std::string name;
  bool isDouble = false;    ///< else single precision; of arrays of three numbers a row
  std::uint64_t begin = 0;  ///< of the numbers in the file
  /// Where the header says its least and largest length: the places of these numbers in the header.
  struct Range {
    std::size_t begin;
    std::size_t end;
    bool isLargest;
    bool isAttribute;  ///< else the text of an element
  };
  std::vector<Range> ranges;

  std::uint64_t rowBytes() const { return isDouble ? 24 : 12; }
};

/// A piece of such a file.
struct RawPiece {
  std::int64_t points = 0;
  RawArray positions;
  std::vector<RawArray> pointArrays;  ///< those of three real numbers a row
  std::string normals;                ///< the name of the active normals; empty for none
  std::int64_t cells = 0;
  std::uint64_t cellTypes = 0;  ///< where one byte a cell begins; 0 for polygons
};

/// A VTK XML file (.vtu, .vtp) whose arrays are appended raw and not compressed: positions can be rewritten
/// while the file is copied, with little memory and every other byte as it was.
struct RawXmlLayout {
  std::string header;  ///< the text through the underscore that the data follows
  std::uint64_t fileBytes = 0;
  bool isSwapped = false;  ///< the other byte order than the machine's
  std::vector<RawPiece> pieces;
  std::set<std::string> cellArrays;  ///< the names of all arrays of cells
};

/// Nothing where the file is written in another way, or with anything unusual: VTK reads it then, or says
/// what is wrong. Throws InvalidInput that names the file and the array where the file ends too early.
std::optional<RawXmlLayout> rawXmlLayoutOf(const std::filesystem::path& path);

}  // namespace pbffd
