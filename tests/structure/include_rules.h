#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pbffd::test {

/// What is wrong with the #include lines of one source file of core/, ui/ or app/: a sentence each, that names
/// file, line and header. The rules: no arrow upward in base <- mesh <- ffd <- project <- ui/document <-
/// ui/models, ui/views <- ui/controllers <- ui/window <- app; no Qt in core and the command line; VTK in
/// ui/views and app/dataset only; every other library inside the files that wrap it.
/// `path` is relative to the root of the sources, with '/' ("core/mesh/mesh.h").
std::vector<std::string> includeViolations(std::string_view path, std::string_view source);

}  // namespace pbffd::test
