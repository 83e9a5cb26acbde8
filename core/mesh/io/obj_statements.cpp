#include "core/mesh/io/obj_statements.h"

#include "core/base/text.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace pbffd::io {
namespace {

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool isPlain(std::string_view keyword) {
  return isOneOf(keyword, {"g", "o", "s", "usemtl", "mtllib", "mg", "lod", "usemap", "maplib", "bevel",
                           "c_interp", "d_interp", "shadow_obj", "trace_obj"});
}

bool isFreeForm(std::string_view keyword) {
  return isOneOf(keyword,
                 {"vp",   "deg", "bmat", "step", "cstype", "curv",  "curv2", "surf", "parm", "trim", "hole",
                  "scrv", "sp",  "end",  "con",  "ctech",  "stech", "bsp",   "bzp",  "cdc",  "cdp",  "res"});
}

}  // namespace

std::optional<ObjCorner> parseObjCorner(std::string_view word) {
  std::array<std::optional<std::int64_t>, 3> parts;
  const char* at = word.data();
  const char* end = at + word.size();
  for (std::size_t part = 0; part < parts.size() && at < end; ++part) {
    if (*at != '/') {
      std::int64_t value = 0;
      const auto [stop, error] = std::from_chars(at, end, value);
      if (error != std::errc()) {
        return std::nullopt;
      }
      parts[part] = value;
      at = stop;
    }
    if (at == end) {
      break;
    }
    if (*at != '/' || part == 2) {
      return std::nullopt;
    }
    ++at;
  }
  if (!parts[0]) {
    return std::nullopt;
  }
  return ObjCorner{*parts[0], parts[1], parts[2]};
}

ObjCounts estimateObjCounts(std::string_view bytes) {
  ObjCounts counts;
  for (std::size_t line = 0; line < bytes.size();) {
    const std::string_view start = bytes.substr(line, 3);
    if (start.starts_with("v ")) {
      ++counts.vertices;
    } else if (start.starts_with("f ")) {
      ++counts.faces;
    } else if (start == "vn ") {
      ++counts.normals;
    }
    const std::size_t end = bytes.find('\n', line);
    line = end == std::string_view::npos ? bytes.size() : end + 1;
  }
  return counts;
}

void OtherStatements::note(std::string_view keyword, const TextScanner& scanner) {
  if (isPlain(keyword)) {
    return;
  }
  if (std::any_of(keyword.begin(), keyword.end(), [](char c) { return c >= 0 && c < ' '; })) {
    scanner.fail("there are control characters, so this is no text",
                 "Choose an OBJ file, or give the file the ending of its format.");
  }
  const bool isElement = keyword == "p" || keyword == "l";
  const bool isCall = keyword == "call" || keyword == "csh";
  Kind& kind = isElement ? elements_ : isFreeForm(keyword) ? freeForm_ : isCall ? calls_ : unknown_;
  if (kind.count++ == 0) {
    kind.firstLine = scanner.line();
    kind.firstWord = inQuotes(keyword);
  }
}

void OtherStatements::addRemarks(std::vector<std::string>& remarks) const {
  const auto add = [&](const Kind& kind, std::string_view what) {
    if (kind.count > 0) {
      remarks.push_back(format("{} of {}, the first on line {}, {} kept by an OBJ export but not shown.",
                               counted(kind.count, "statement", "statements"), what, kind.firstLine,
                               kind.count == 1 ? "is" : "are"));
    }
  };
  add(elements_, "points or lines (p, l)");
  add(freeForm_, "free-form curves or surfaces");
  add(calls_, "other files to include (call, csh)");
  add(unknown_, format("a kind that OBJ does not have ({})", unknown_.firstWord));
}

}  // namespace pbffd::io
