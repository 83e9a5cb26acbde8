#include "app/cli/files.h"

#include "app/cli/output.h"
#include "core/mesh/io/mesh_io.h"

namespace pbffd::cli {

LoadedProject openProject(const std::filesystem::path& path, const Progress& progress) {
  if (formatOfEnding(path) != MeshFormat::none && std::filesystem::is_regular_file(path)) {
    throw InvalidInput(format(
        "Could not open {}: it is a mesh, not a project. Make a project of it first: pbffd place {} -o {}.",
        path.string(), path.string(), path.stem().string() + ".pbffd"));
  }
  LoadedProject loaded = loadProject(path, progress);
  printRemarks(loaded.remarks);
  return loaded;
}

void requireProjectName(const std::filesystem::path& output, const std::filesystem::path& input) {
  const auto fail = [&](std::string_view why) {
    throw InvalidInput(format("Could not write the project {}: {}. Nothing was written; name it {}.",
                              output.string(), why, (output.parent_path() / "NAME.pbffd").string()));
  };
  if (output == "-") {
    fail("a project is a file, not a stream");
  }
  if (formatOfEnding(output) != MeshFormat::none) {
    fail("its ending is that of a mesh");
  }
  std::error_code none;
  if (!input.empty() && std::filesystem::equivalent(output, input, none)) {
    fail("the mesh lies there");
  }
}

}  // namespace pbffd::cli
