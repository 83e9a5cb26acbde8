#include "core/project/json_text.h"

#include "core/base/text.h"

#include <algorithm>
#include <set>
#include <vector>

namespace pbffd {
namespace {

/// Deeper values would run out of stack where they are walked.
constexpr int greatestDepth = 200;

std::string placeOf(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(text.size(), byte == 0 ? 0 : byte - 1));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t lastBreak = before.rfind('\n');
  const std::size_t column =
      lastBreak == std::string_view::npos ? before.size() + 1 : before.size() - lastBreak;
  return format("line {}, column {}", line, column);
}

/// The names met so far in each object that is open.
class OpenObjects {
 public:
  void begin() { names_.emplace_back(); }
  void end() { names_.pop_back(); }
  /// Whether the innermost object had this name before.
  bool isRepeated(const std::string& name) { return !names_.back().insert(name).second; }

 private:
  std::vector<std::set<std::string>> names_;
};

}  // namespace

Json parsedJson(std::string_view text) {
  std::size_t finished = 0;
  bool isList = false;
  const auto fail = [&](const std::string& what) -> void { throw JsonTextError(what, isList, finished); };
  OpenObjects objects;
  const auto watchNames = [&](Json::parse_event_t event, const Json& parsed) {
    if (event == Json::parse_event_t::object_start) {
      objects.begin();
    } else if (event == Json::parse_event_t::object_end) {
      objects.end();
    } else if (event == Json::parse_event_t::key && objects.isRepeated(parsed.get<std::string>())) {
      fail(format("it has \"{}\" twice in one object", parsed.get<std::string>()));
    }
  };
  const Json::parser_callback_t watch = [&](int depth, Json::parse_event_t event, const Json& parsed) {
    watchNames(event, parsed);
    isList = isList || (depth == 0 && event == Json::parse_event_t::array_start);
    const bool isEnd = event == Json::parse_event_t::object_end || event == Json::parse_event_t::array_end ||
                       event == Json::parse_event_t::value;
    finished += depth == 1 && isEnd ? 1 : 0;
    if (depth > greatestDepth) {
      fail(format("it is nested more than {} deep", greatestDepth));
    }
    return true;
  };
  if (text.empty()) {
    fail("there is nothing in it");
  }
  try {
    return Json::parse(text, watch);
  } catch (const Json::parse_error& error) {
    fail(placeOf(text, error.byte) +
         " is not valid JSON: a number must be finite, a text stand in double quotes, and commas only between "
         "elements");
  } catch (const Json::exception&) {
    fail("a number is too large to be finite");
  }
  return {};
}

}  // namespace pbffd
