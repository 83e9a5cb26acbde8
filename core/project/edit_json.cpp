#include "core/project/edit_json.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/edit_from_json.h"

namespace pbffd {
namespace {

/// Parses `json`; on a mistake in the text says which element of the list it stands in.
Json parsedText(std::string_view json, const std::string& name) {
  std::size_t finished = 0;
  bool isList = false;
  const Json::parser_callback_t count = [&](int depth, Json::parse_event_t event, Json&) {
    isList = isList || (depth == 0 && event == Json::parse_event_t::array_start);
    const bool isEnd = event == Json::parse_event_t::object_end || event == Json::parse_event_t::array_end ||
                       event == Json::parse_event_t::value;
    finished += depth == 1 && isEnd ? 1 : 0;
    return true;
  };
  const auto place = [&] {
    return isList ? format(", edit {} (at /{})", finished + 1, finished) : std::string();
  };
  try {
    return Json::parse(json, count);
  } catch (const Json::parse_error& error) {
    const LineAndColumn at = lineAndColumn(json, error.byte);
    throw InvalidInput(
        format("{}{}: line {}, column {} is not valid JSON. A number must be finite, a text stand in "
               "double quotes, and commas only between elements.",
               name, place(), at.line, at.column));
  } catch (const Json::out_of_range&) {
    throw InvalidInput(format("{}{}: a number is too large to be finite.", name, place()));
  }
}

}  // namespace

std::vector<Edit> parseEdits(std::string_view json, const std::string& name) {
  const Json document = parsedText(json, name);
  std::vector<Edit> edits;
  try {
    if (document.is_object()) {
      edits.push_back(editFrom({document, ""}));
      return edits;
    }
    if (!document.is_array()) {
      throw InvalidInput("a list of edits is expected, as [{\"move\": {...}}, ...]");
    }
    edits = editsFrom({document, ""});
  } catch (const InvalidInput& error) {
    throw InvalidInput(format("{}: {}", name, error.what()));
  }
  return edits;
}

std::string toJson(const Edit& edit) {
  return editToJson(edit).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace pbffd
