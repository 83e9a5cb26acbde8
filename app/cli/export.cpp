#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/output.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/mesh/io/export_losses.h"
#include "core/mesh/io/mesh_io.h"
#include "core/project/shape.h"

#include <filesystem>
#include <memory>

namespace pbffd::cli {
namespace {

struct ExportCommand {
  std::filesystem::path project;
  std::filesystem::path mesh;
};

void exportMesh(const ExportCommand& command, const Progress& progress) {
  const MeshFormat format = formatOfEnding(command.mesh);
  if (format == MeshFormat::none) {
    throw InvalidInput(
        pbffd::format("Could not export to {}: its ending names no mesh format. Use .obj, .off, .ply or .stl.",
                      command.mesh.string()));
  }
  const Project project = openProject(command.project, progress).project;
  WeightCache weights;
  const DeformedShape shape = deformedShape(project, weights, progress);
  const std::string bytes = encodeMesh(project.mesh->mesh(), shape, format, progress);
  progress.throwIfCancelled();
  writeFileAtomically(command.mesh, bytes);
  printRemarks(exportLosses(project.mesh->mesh(), format));
  print(pbffd::format("Exported {} vertices to {}.\n", grouped(project.mesh->vertexCount()),
                      command.mesh.string()));
}

}  // namespace

void addExport(CLI::App& app, Action& action) {
  CLI::App* subcommand = app.add_subcommand("export", "Write the deformed mesh of a project");
  const auto command = std::make_shared<ExportCommand>();
  subcommand->add_option("PROJECT", command->project, "The project (PBFFD)")->required();
  subcommand->add_option("-o,--output", command->mesh, "The mesh to write; its ending is the format")
      ->required()
      ->type_name("MESH");
  subcommand->callback(
      [command, &action] { action = [command](const Progress& progress) { exportMesh(*command, progress); }; });
}

}  // namespace pbffd::cli
