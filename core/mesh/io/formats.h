#pragma once

#include "core/mesh/io/input.h"
#include "core/mesh/io/reshaped.h"
#include "core/mesh/mesh.h"

#include <string>

namespace pbffd::io {

// What each format can do. `read` leaves Mesh::source to its caller and throws InvalidInput; `rewrite` takes
// a mesh of that format and gives its source with the numbers replaced that changed; `write` makes a new
// file of a mesh of any origin.

Mesh readObj(const Input& input);
std::string rewriteObj(const Reshaped& shape);
std::string writeObj(const Reshaped& shape);

Mesh readOff(const Input& input);
std::string rewriteOff(const Reshaped& shape);
std::string writeOff(const Reshaped& shape);

Mesh readPly(const Input& input);
std::string rewritePly(const Reshaped& shape);
std::string writePly(const Reshaped& shape);

Mesh readStl(const Input& input);
std::string rewriteStl(const Reshaped& shape);
std::string writeStl(const Reshaped& shape);

}  // namespace pbffd::io
