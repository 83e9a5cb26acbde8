#pragma once

#include "core/project/edit.h"

#include <string>
#include <string_view>
#include <vector>

namespace pbffd {

/// A JSON array of edits, or a single edit, as in contract.md, section 2. Throws InvalidInput that names
/// the edit's index, the key, and what was expected; an unknown edit or key is an error.
std::vector<Edit> parseEdits(std::string_view json, const std::string& name);

/// One edit as one line of JSON; parseEdits() gives the same edit back, to the last bit.
std::string toJson(const Edit& edit);

}  // namespace pbffd
