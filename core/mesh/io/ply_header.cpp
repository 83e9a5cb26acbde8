#include "core/mesh/io/ply_header.h"

#include "core/base/text.h"
#include "core/mesh/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pbffd::io {
namespace {

std::optional<PlyType> typeOf(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{{
      {"char", PlyType::int8},
      {"int8", PlyType::int8},
      {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},
      {"short", PlyType::int16},
      {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},
      {"uint16", PlyType::uint16},
      {"int", PlyType::int32},
      {"int32", PlyType::int32},
      {"uint", PlyType::uint32},
      {"uint32", PlyType::uint32},
      {"float", PlyType::float32},
      {"float32", PlyType::float32},
      {"double", PlyType::float64},
      {"float64", PlyType::float64},
  }};
  const auto found = std::ranges::find(names, word, [](const auto& entry) { return entry.first; });
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

class HeaderParser {
 public:
  explicit HeaderParser(const Input& input) : text_(input, {}) {}

  PlyHeader parse();

 private:
  void readFormat();
  void readElement();
  void readProperty();
  PlyType type();
  std::string name(std::string_view what);
  void endLine();

  TextScanner text_;
  PlyHeader header_;
  bool hasFormat_ = false;
};

PlyHeader HeaderParser::parse() {
  if (const std::string_view magic = text_.word(); magic != "ply") {
    text_.fail(format("the file begins with {} and not with \"ply\"", inQuotes(magic)),
               "Choose a PLY file, or give the file the ending of its format.");
  }
  for (std::string_view word = text_.firstWordOfNextLine(); word != "end_header";
       word = text_.firstWordOfNextLine()) {
    if (word.empty()) {
      text_.fail("the file ends within its header", adviceCutOff);
    }
    if (word == "format") {
      readFormat();
    } else if (word == "element") {
      readElement();
    } else if (word == "property") {
      readProperty();
    } else if (word != "comment" && word != "obj_info") {
      text_.fail(format("{} is no word of a PLY header", inQuotes(word)));
    }
  }
  if (!hasFormat_) {
    text_.fail("the header ends without a line \"format\"");
  }
  endLine();
  return std::move(header_);
}

/// The data begin behind the line end of "end_header". A file whose lines end in CR alone has no LF there
/// that belongs to the line, even when the data begin with that byte.
void HeaderParser::endLine() {
  const std::string_view bytes = text_.input().bytes;
  const std::size_t firstEnd = bytes.find_first_of("\r\n");
  const bool endsInCrAlone = bytes[firstEnd] == '\r' && bytes.substr(firstEnd + 1, 1) != "\n";
  std::size_t at = text_.byte();
  while (at < bytes.size() && (bytes[at] == ' ' || bytes[at] == '\t')) {
    ++at;
  }
  if (at < bytes.size() && bytes[at] == '\r') {
    ++at;
    if (!endsInCrAlone && at < bytes.size() && bytes[at] == '\n') {
      ++at;
    }
  } else if (at < bytes.size() && bytes[at] == '\n') {
    ++at;
  } else if (at < bytes.size()) {
    text_.fail("something follows \"end_header\" on its line");
  }
  header_.bodyByte = at;
  header_.bodyLine = text_.line() + 1;
}

void HeaderParser::readFormat() {
  const std::string_view word = text_.word();
  if (word == "ascii") {
    header_.encoding = PlyEncoding::ascii;
  } else if (word == "binary_little_endian") {
    header_.encoding = PlyEncoding::littleEndian;
  } else if (word == "binary_big_endian") {
    header_.encoding = PlyEncoding::bigEndian;
  } else {
    text_.fail(format("{} is no format of PLY", inQuotes(word)));
  }
  if (const std::string_view version = text_.word(); version != "1.0") {
    text_.fail(format("the version of the format is {}; 1.0 is read", inQuotes(version)),
               "Export it as PLY 1.0.");
  }
  hasFormat_ = true;
}

std::string HeaderParser::name(std::string_view what) {
  const std::string_view word = text_.word();
  if (word.empty()) {
    text_.fail(format("{} has no name", what));
  }
  return std::string(word);
}

void HeaderParser::readElement() {
  PlyElement element{name("an element"), 0, {}};
  const std::int64_t count = text_.integer(text_.word(), "the number of an element");
  if (count < 0) {
    text_.fail(format("there are {} of the element {}", count, inQuotes(element.name)));
  }
  if (header_.find(element.name) != nullptr) {
    text_.fail(format("the element {} is there twice", inQuotes(element.name)));
  }
  element.count = static_cast<std::size_t>(count);
  header_.elements.push_back(std::move(element));
}

PlyType HeaderParser::type() {
  const std::string_view word = text_.word();
  const auto found = typeOf(word);
  if (!found) {
    text_.fail(format("{} is no type of PLY", inQuotes(word)));
  }
  return *found;
}

void HeaderParser::readProperty() {
  if (header_.elements.empty()) {
    text_.fail("a property comes before the first element");
  }
  PlyElement& element = header_.elements.back();
  const std::string_view first = text_.word();
  PlyProperty property;
  if (first == "list") {
    property.countType = type();
    property.type = type();
  } else if (const auto known = typeOf(first)) {
    property.type = *known;
  } else {
    text_.fail(format("{} is no type of PLY", inQuotes(first)));
  }
  if (property.countType && !isInteger(*property.countType)) {
    text_.fail("the length of a list has a type that is no whole number");
  }
  property.name = name("a property");
  if (element.find(property.name)) {
    text_.fail(format("the property {} is there twice", inQuotes(property.name)));
  }
  element.properties.push_back(std::move(property));
}

}  // namespace

std::size_t sizeOf(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      return 8;
  }
  return 8;
}

bool isInteger(PlyType type) {
  return type != PlyType::float32 && type != PlyType::float64;
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  const auto found = std::ranges::find(properties, property, &PlyProperty::name);
  if (found == properties.end()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - properties.begin());
}

const PlyElement* PlyHeader::find(std::string_view element) const {
  const auto found = std::ranges::find(elements, element, &PlyElement::name);
  return found == elements.end() ? nullptr : &*found;
}

PlyHeader parsePlyHeader(const Input& input) {
  return HeaderParser(input).parse();
}

}  // namespace pbffd::io
