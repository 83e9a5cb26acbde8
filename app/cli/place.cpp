#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/output.h"
#include "app/cli/place_options.h"
#include "core/base/text.h"
#include "core/mesh/io/mesh_io.h"
#include "core/project/edit.h"

#include <filesystem>
#include <memory>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace pbffd::cli {
namespace {

struct PlaceCommand {
  std::filesystem::path mesh;
  std::filesystem::path project;
  PlacementOptions placement;
};

/// Has long arrays go back to the system as soon as they are freed: a command that runs once has no use for
/// them.
void keepMemorySmall() {
#if defined(__GLIBC__)
  constexpr int longArray = 1 << 20;
  static_cast<void>(mallopt(M_MMAP_THRESHOLD, longArray));
#endif
}

void place(const PlaceCommand& command, const Progress& progress) {
  keepMemorySmall();
  requireProjectName(command.project, command.mesh);
  const auto mesh = std::make_shared<const RestMesh>(readMesh(command.mesh, progress));
  printRemarks(mesh->mesh().remarks);
  Place edit;
  edit.options = command.placement;
  const EditResult result = naming(command.mesh.string(), [&] {
    EditWorkspace workspace;
    workspace.keepsPlacement = false;
    return apply(projectOf(mesh), edit, workspace, progress);
  });
  saveProject(command.project, result.project, {}, progress);
  printRemarks(result.remarks);
  const ControlSet& controls = result.project.controls;
  const auto counted = [](std::size_t count, std::string_view what) {
    return format("{} {}{}", grouped(static_cast<std::int64_t>(count)), what, count == 1 ? "" : "s");
  };
  print(format("Placed {} on {} in {}.\n",
               counted(static_cast<std::size_t>(controls.finest().size()), "control point"),
               counted(controls.levels.size(), "level"), command.project.string()));
}

}  // namespace

void addPlace(CLI::App& app, Action& action) {
  CLI::App* subcommand =
      app.add_subcommand("place", "Place control points in and around a mesh, and make a project of both");
  const auto command = std::make_shared<PlaceCommand>();
  subcommand->add_option("MESH", command->mesh, "The mesh (OBJ, OFF, PLY, STL)")->required();
  subcommand->add_option("-o,--output", command->project, "The project to write (PBFFD)")
      ->required()
      ->type_name("PROJECT");
  const auto placement = addPlacementOptions(*subcommand);
  subcommand->callback([command, placement, &action] {
    command->placement = placement();
    action = [command](const Progress& progress) { place(*command, progress); };
  });
}

}  // namespace pbffd::cli
