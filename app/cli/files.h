#pragma once

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/project_file.h"

#include <filesystem>
#include <string>

namespace pbffd::cli {

/// The project of a file. Throws like loadProject(), and says what to do with a mesh instead.
LoadedProject openProject(const std::filesystem::path& path, const Progress& progress);

/// Throws InvalidInput for a name under which a project could not be opened again: that of a mesh, by its
/// ending or because the mesh `input` lies there, or "-".
void requireProjectName(const std::filesystem::path& output, const std::filesystem::path& input = {});

/// What `work` gives; where it finds the content of `file` unfit, its message begins with the file's name.
template <class Work>
auto naming(const std::string& file, const Work& work) {
  try {
    return work();
  } catch (const InvalidInput& error) {
    throw InvalidInput(format("{}: {}", file, error.what()));
  }
}

}  // namespace pbffd::cli
