#include "core/project/edit_json.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/edit_from_json.h"
#include "core/project/json_text.h"

namespace pbffd {
namespace {

/// Parses `json`; on a mistake in the text says which element of the list it stands in.
Json parsedText(std::string_view json, const std::string& name) {
  try {
    return parsedJson(json);
  } catch (const JsonTextError& error) {
    const std::string place =
        error.isInList ? format(", edit {} (at /{})", error.element + 1, error.element) : std::string();
    throw InvalidInput(format("{}{}: {}", name, place, error.what()));
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
