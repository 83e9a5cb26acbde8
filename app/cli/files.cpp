#include "app/cli/files.h"

#include "core/mesh/io/mesh_io.h"

namespace pbffd::cli {

LoadedProject openProject(const std::filesystem::path& path, const Progress& progress) {
  if (formatOfEnding(path) != MeshFormat::none && std::filesystem::is_regular_file(path)) {
    throw InvalidInput(format(
        "Could not open {}: it is a mesh, not a project. Make a project of it first: pbffd place {} -o {}.",
        path.string(), path.string(), path.stem().string() + ".pbffd"));
  }
  return loadProject(path, progress);
}

}  // namespace pbffd::cli
