#pragma once

#include "core/base/error.h"
#include "core/project/json_reader.h"

#include <cstddef>
#include <string>
#include <string_view>

// Private to the .cpp files of this folder.

namespace pbffd {

/// What is wrong with a text that should be JSON: "line 3, column 17 is not valid JSON".
class JsonTextError : public InvalidInput {
 public:
  JsonTextError(const std::string& what, bool inList, std::size_t at)
      : InvalidInput(what), isInList(inList), element(at) {}

  bool isInList;        ///< whether the text is one list
  std::size_t element;  ///< the element of it in which the mistake stands
};

/// Parses a text. Throws JsonTextError for what is not JSON, for numbers that no double holds, for a name that
/// one object has twice, and for nesting deeper than anything that this program writes.
Json parsedJson(std::string_view text);

}  // namespace pbffd
