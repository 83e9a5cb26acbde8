#pragma once

#include "core/project/edit.h"
#include "core/project/json_reader.h"

// Edits from and to JSON values; private to the .cpp files of this folder.

namespace pbffd {

/// An object with one key, the edit's name. Throws InvalidInput with the place of what is wrong.
Edit editFrom(const JsonReader& reader);

/// A list of them; messages begin with "edit 3 (move): ".
std::vector<Edit> editsFrom(const JsonReader& reader);

Json editToJson(const Edit& edit);

}  // namespace pbffd
