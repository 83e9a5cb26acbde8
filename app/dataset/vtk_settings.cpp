#include "app/dataset/vtk_settings.h"

#include "app/dataset/xml_tags.h"
#include "core/base/error.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>
#include <string_view>

namespace pbffd {
namespace {

std::string bytesOf(const std::filesystem::path& path, std::streamoff from, std::size_t count) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(from, from < 0 ? std::ios::end : std::ios::beg);
  std::string bytes(count, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

/// The tags through the first one named `last`, of a text that may end within a tag.
std::vector<XmlTag> tagsThrough(const std::string& text, std::string_view last) {
  try {
    return scanXmlTags(text, last);
  } catch (const InvalidInput&) {
    return {};
  }
}

/// Empty where no number of points, cells, ... is below 0.
std::string negativeCount(const XmlTag& piece) {
  for (const XmlTag::Attribute& attribute : piece.attributes) {
    if (attribute.name.starts_with("NumberOf") && attribute.value.find('-') != std::string::npos) {
      return attribute.name + "=\"" + attribute.value + "\"";
    }
  }
  return {};
}

/// The tags through the first array of the first piece, which data of the file itself may stand before.
std::vector<XmlTag> pieceBeginning(const std::string& text) {
  std::vector<XmlTag> tags = tagsThrough(text, "Piece");
  if (tags.empty() || tags.back().name != "Piece") {
    return tags;
  }
  const std::vector<XmlTag> inPiece = tagsThrough(text.substr(tags.back().end), "DataArray");
  tags.insert(tags.end(), inPiece.begin(), inPiece.end());
  return tags;
}

}  // namespace

XmlSettings xmlSettingsOf(const std::filesystem::path& path) {
  // The few files whose header is longer are written as VTK does by default.
  constexpr std::size_t longest = std::size_t{4} << 20;
  constexpr std::size_t start = 1 << 16;
  XmlSettings settings;
  std::vector<XmlTag> tags = pieceBeginning(bytesOf(path, 0, start));
  if (tags.empty() || tags.back().name != "DataArray") {
    tags = pieceBeginning(bytesOf(path, 0, longest));
  }
  for (const XmlTag& tag : tags) {
    if (tag.name == "VTKFile" && !tag.isEnd) {
      settings.byteOrder = tag.value("byte_order");
      settings.headerType = tag.value("header_type");
      settings.compressor = tag.value("compressor");
    } else if (tag.name == "Piece" && !tag.isEnd) {
      settings.badCount = negativeCount(tag);
    }
  }
  settings.format = tags.empty() ? std::string() : tags.back().value("format");
  // Raw data is no text, so the tag is looked for by its letters.
  const std::string header = settings.format == "appended" ? bytesOf(path, 0, longest) : std::string();
  if (const std::size_t at = header.find("<AppendedData"); at != std::string::npos) {
    const std::size_t end = header.find('>', at);
    if (end != std::string::npos) {
      for (const XmlTag& tag : tagsThrough(header.substr(at, end + 1 - at), "AppendedData")) {
        settings.encoding = tag.value("encoding");
      }
    }
  }
  return settings;
}

LegacyHeader legacyHeaderOf(const std::filesystem::path& path) {
  std::istringstream lines(bytesOf(path, 0, 4096));
  LegacyHeader header;
  std::string line;
  for (int number = 0; number < 16 && std::getline(lines, line); ++number) {
    std::transform(line.begin(), line.end(), line.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    std::istringstream words(line);
    std::string word;
    if (number == 0) {
      const std::size_t at = line.find("VERSION ");
      if (at != std::string::npos && line.size() >= at + 11) {
        header.version = 10 * (line[at + 8] - '0') + (line[at + 10] - '0');
      }
    } else if (words >> word && word == "DATASET" && number >= 2) {
      words >> header.dataset;
      break;
    }
  }
  return header;
}

}  // namespace pbffd
