#include "app/dataset/raw_xml_layout.h"

#include "app/dataset/dataset.h"
#include "app/dataset/vtk_settings.h"
#include "app/dataset/xml_tags.h"
#include "core/base/error.h"
#include "core/base/text.h"

#include <bit>
#include <charconv>
#include <cstring>
#include <fstream>
#include <string_view>
#include <utility>

namespace pbffd {
namespace {

/// Thrown within this file: VTK shall read it.
struct Unusual {};

std::int64_t numberOf(const std::string& text) {
  std::int64_t number = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (code != std::errc() || end != text.data() + text.size() || number < 0) {
    throw Unusual();
  }
  return number;
}

/// The text of the file through the underscore that begins the appended data.
std::string headerOf(std::ifstream& file) {
  constexpr std::size_t step = 1 << 16;
  constexpr std::size_t longest = std::size_t{64} << 20;
  std::string text;
  while (text.size() < longest) {
    const std::size_t before = text.size();
    text.resize(before + step);
    file.read(text.data() + before, step);
    text.resize(before + static_cast<std::size_t>(file.gcount()));
    const std::size_t from = before < 64 ? 0 : before - 64;
    const std::size_t tag = text.find("<AppendedData", from);
    const std::size_t underscore = tag == std::string::npos ? tag : text.find('_', text.find('>', tag));
    if (underscore != std::string::npos) {
      text.resize(underscore + 1);
      return text;
    }
    if (file.gcount() == 0) {
      break;
    }
  }
  throw Unusual();
}

class LayoutReader {
 public:
  LayoutReader(const std::filesystem::path& path, std::ifstream& file) : path_(path), file_(file) {
    layout_.header = headerOf(file);
    layout_.fileBytes = std::filesystem::file_size(path);
    try {
      tags_ = scanXmlTags(layout_.header, "AppendedData");
    } catch (const InvalidInput&) {
      throw Unusual();
    }
  }

  RawXmlLayout read() {
    std::vector<std::string> open;
    for (std::size_t t = 0; t < tags_.size(); ++t) {
      const XmlTag& tag = tags_[t];
      if (tag.isEnd) {
        if (!open.empty()) {
          open.pop_back();
        }
        continue;
      }
      take(t, open.empty() ? std::string() : open.back());
      if (!tag.isEmpty) {
        open.push_back(tag.name);
      }
    }
    for (const RawPiece& piece : layout_.pieces) {
      if (piece.points > 0 && piece.positions.begin == 0) {
        throw Unusual();
      }
    }
    return std::move(layout_);
  }

 private:
  void take(std::size_t t, const std::string& parent) {
    const XmlTag& tag = tags_[t];
    if (tag.name == "VTKFile") {
      takeFile(tag);
    } else if (tag.name == "UnstructuredGrid" || tag.name == "PolyData") {
      if (tag.find("TimeValues") != nullptr || tag.find("NumberOfTimeSteps") != nullptr) {
        throw Unusual();
      }
    } else if (tag.name == "Piece") {
      layout_.pieces.emplace_back();
      layout_.pieces.back().points = numberOf(tag.value("NumberOfPoints"));
      layout_.pieces.back().cells = isGrid_ ? numberOf(tag.value("NumberOfCells")) : 0;
      requireRoom(layout_.pieces.back());
    } else if (tag.name == "PointData" && !layout_.pieces.empty()) {
      layout_.pieces.back().normals = tag.value("Normals");
    } else if (tag.name == "DataArray" && !layout_.pieces.empty()) {
      takeArray(t, parent);
    }
  }

  /// So that no product of these numbers overflows.
  void requireRoom(const RawPiece& piece) const {
    constexpr std::uint64_t leastPoint = 12;
    if (static_cast<std::uint64_t>(piece.points) > layout_.fileBytes / leastPoint ||
        static_cast<std::uint64_t>(piece.cells) > layout_.fileBytes) {
      throw InvalidInput(
          format("Could not read {}: its header promises {} points and {} cells, more than its {} bytes can "
                 "hold. It is cut "
                 "short or damaged; copy or write it anew.",
                 path_.string(), piece.points, piece.cells, layout_.fileBytes));
    }
  }

  void takeFile(const XmlTag& tag) {
    constexpr bool isLittle = std::endian::native == std::endian::little;
    const std::string type = tag.value("type");
    const std::string order = tag.value("byte_order");
    isGrid_ = type == "UnstructuredGrid";
    const bool isKnown = (isGrid_ || type == "PolyData") && (order == "LittleEndian" || order == "BigEndian");
    if (!isKnown || tag.find("compressor") != nullptr) {
      throw Unusual();
    }
    layout_.isSwapped = (order == "LittleEndian") != isLittle;
    sizeBytes_ = tag.value("header_type") == "UInt64" ? 8 : 4;
  }

  void takeArray(std::size_t t, const std::string& parent) {
    const XmlTag& tag = tags_[t];
    RawPiece& piece = layout_.pieces.back();
    requireComponents(tag);
    if (tag.value("format") != "appended" || tag.find("TimeStep") != nullptr) {
      throw Unusual();
    }
    if (parent == "CellData") {
      layout_.cellArrays.insert(tag.value("Name"));
    }
    const std::string type = tag.value("type");
    const bool isReal = type == "Float32" || type == "Float64";
    if (parent == "Cells" && tag.value("Name") == "types") {
      if (type != "UInt8") {
        throw Unusual();
      }
      piece.cellTypes = dataOf(tag, static_cast<std::uint64_t>(piece.cells));
      return;
    }
    const bool isRows = isReal && tag.value("NumberOfComponents") == "3";
    if (parent == "Points" && !isRows) {
      throw Unusual();
    }
    if (!isRows || (parent != "Points" && parent != "PointData")) {
      requireWhole(tag);
      return;
    }
    RawArray array{tag.value("Name"), type == "Float64", 0, rangesOf(t)};
    array.begin = dataOf(tag, array.rowBytes() * static_cast<std::uint64_t>(piece.points));
    if (parent == "Points") {
      piece.positions = std::move(array);
    } else {
      piece.pointArrays.push_back(std::move(array));
    }
  }

  /// VTK 9.1 would ask for that much memory.
  void requireComponents(const XmlTag& tag) const {
    if (const std::string components = tag.value("NumberOfComponents"); components.starts_with('-')) {
      throw InvalidInput(format(
          "Could not read {}: the array '{}' says NumberOfComponents=\"{}\". The file is damaged; write it "
          "anew.",
          path_.string(), tag.value("Name"), components));
    }
  }

  /// Where an array's numbers begin, which must take so many bytes.
  std::uint64_t dataOf(const XmlTag& tag, std::uint64_t bytes) {
    const Data data = requireWhole(tag);
    if (data.bytes != bytes) {
      throw Unusual();
    }
    return data.begin;
  }

  struct Data {
    std::uint64_t begin;
    std::uint64_t bytes;
  };
  /// Throws where the file ends before the array does.
  Data requireWhole(const XmlTag& tag) {
    const std::uint64_t at = layout_.header.size() + static_cast<std::uint64_t>(numberOf(tag.value("offset")));
    const std::uint64_t begin = at + sizeBytes_;
    std::uint64_t bytes = 0;
    if (begin <= layout_.fileBytes) {
      file_.clear();
      file_.seekg(static_cast<std::streamoff>(at));
      std::string size(sizeBytes_, '\0');
      file_.read(size.data(), static_cast<std::streamsize>(sizeBytes_));
      bytes = sizeOf(size);
    }
    if (begin > layout_.fileBytes || bytes > layout_.fileBytes - begin) {
      throw InvalidInput(format(
          "Could not read {}: the array '{}' begins at byte {} and has {} bytes, but the file ends at byte "
          "{}. It is cut short or damaged; copy or write it anew.",
          path_.string(), tag.value("Name"), begin, bytes, layout_.fileBytes));
    }
    return {begin, bytes};
  }

  std::uint64_t sizeOf(std::string bytes) const {
    constexpr bool isLittle = std::endian::native == std::endian::little;
    if (layout_.isSwapped) {
      bytes.assign(bytes.rbegin(), bytes.rend());
    }
    std::uint64_t size = 0;
    char* to = reinterpret_cast<char*>(&size) + (isLittle ? 0 : sizeof size - bytes.size());
    std::memcpy(to, bytes.data(), bytes.size());
    return size;
  }

  /// The attributes RangeMin and RangeMax, and the key L2_NORM_RANGE, which says the same.
  std::vector<RawArray::Range> rangesOf(std::size_t t) const {
    std::vector<RawArray::Range> ranges;
    const XmlTag& array = tags_[t];
    for (const char* name : {"RangeMin", "RangeMax"}) {
      if (const XmlTag::Attribute* attribute = array.find(name)) {
        ranges.push_back({attribute->begin, attribute->end, std::string_view(name) == "RangeMax", true});
      }
    }
    bool isNorm = false;
    for (std::size_t i = t + 1; !array.isEmpty && i + 1 < tags_.size(); ++i) {
      const XmlTag& tag = tags_[i];
      if (tag.isEnd && tag.name == "DataArray") {
        break;
      }
      if (tag.name == "InformationKey" && !tag.isEnd) {
        const std::string key = tag.value("name");
        isNorm = key == "L2_NORM_RANGE" || key == "L2_NORM_FINITE_RANGE";
        if (!isNorm && key.find("RANGE") != std::string::npos) {
          throw Unusual();
        }
      } else if (isNorm && tag.name == "Value" && !tag.isEnd && !tag.isEmpty) {
        ranges.push_back({tag.end, tags_[i + 1].begin, tag.value("index") == "1", false});
      }
    }
    return ranges;
  }

  const std::filesystem::path& path_;
  std::ifstream& file_;
  RawXmlLayout layout_;
  std::vector<XmlTag> tags_;
  bool isGrid_ = false;
  std::size_t sizeBytes_ = 4;
};

}  // namespace

std::optional<RawXmlLayout> rawXmlLayoutOf(const std::filesystem::path& path) {
  const std::string ending = endingOf(path);
  const bool maybe = (ending == ".vtu" || ending == ".vtp") && std::filesystem::is_regular_file(path);
  if (!maybe || xmlSettingsOf(path).format != "appended" || xmlSettingsOf(path).encoding == "base64") {
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  try {
    return LayoutReader(path, file).read();
  } catch (const Unusual&) {
    return std::nullopt;
  }
}

}  // namespace pbffd
