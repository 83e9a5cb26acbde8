#pragma once

#include "core/project/json_reader.h"

#include <string>

// What this program does not know of a file, kept and put back; private to the .cpp files of this folder.

namespace pbffd {

/// The keys of an object that `known` does not have, and within objects that both have the same again. Empty
/// for what is no object.
Json leftover(const Json& original, const Json& known);

/// The text of an object, nothing for an empty one.
std::string textOf(const Json& object);

/// Adds the keys of `leftover` (a text of textOf()) that `target` does not have.
void overlay(Json& target, const std::string& leftover);

}  // namespace pbffd
