#pragma once

#include "core/ffd/control_set.h"
#include "core/project/json_reader.h"

// The control set within project.json; private to the .cpp files of this folder.

namespace pbffd {

/// An object with "basis", "master" and "levels".
Json controlsToJson(const ControlSet& set);

/// Reads them from the whole document. Throws InvalidInput with the place of what is wrong: frames that cannot
/// be used, identifiers used twice, levels that do not fit together.
ControlSet controlsFrom(const JsonReader& document);

}  // namespace pbffd
