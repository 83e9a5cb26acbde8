#pragma once

#include <filesystem>
#include <string>

namespace pbffd {

/// How a VTK XML file was written, so that the deformed one is written alike.
struct XmlSettings {
  std::string byteOrder;   ///< "LittleEndian", "BigEndian"; empty: the machine's
  std::string headerType;  ///< "UInt32", "UInt64"; empty: UInt32
  std::string compressor;  ///< VTK's class name; empty: none
  std::string format;      ///< of the arrays: "ascii", "binary", "appended"
  std::string encoding;    ///< of appended data: "raw", "base64"
  std::string badCount;    ///< a number of the first piece's parts that is below 0, as it stands there
};

/// The settings of the first array of a file's first piece. What cannot be read is left empty: the reader will
/// say what is wrong.
XmlSettings xmlSettingsOf(const std::filesystem::path& path);

/// What a legacy file says of itself in its first lines.
struct LegacyHeader {
  std::string dataset;  ///< "UNSTRUCTURED_GRID", ...; in capitals; empty where there is none
  int version = 0;      ///< 42 for 4.2
};
LegacyHeader legacyHeaderOf(const std::filesystem::path& path);

}  // namespace pbffd
