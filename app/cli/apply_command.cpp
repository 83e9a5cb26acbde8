#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/output.h"
#include "app/dataset/apply.h"
#include "core/base/text.h"
#include "core/project/project_file.h"

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace pbffd::cli {
namespace {

struct ApplyCommand {
  std::filesystem::path project;
  std::filesystem::path source;
  std::filesystem::path target;
  std::string align = "none";
  std::vector<std::string> transports;
};

void applyProject(const ApplyCommand& command, InterruptWatch& watch, const Progress& progress) {
  ApplyOptions options;
  options.staging = [&watch](const std::filesystem::path& folder) {
    watch.setLastWords([folder] {
      std::error_code ignored;
      std::filesystem::remove_all(folder, ignored);
      return lastWords();
    });
  };
  options.align = command.align == "similarity";
  options.transports = parseTransports(command.transports);
  const Project project = openProject(command.project, progress).project;
  const ApplyReport report = applyToFile(project, command.source, command.target, options, progress);
  printRemarks(withOptions(report.remarks));
  print(pbffd::format("Deformed {} points{}; wrote {}.\n", grouped(report.points),
                      report.pieces == 1 ? "" : pbffd::format(" in {} pieces", report.pieces),
                      command.target.string()));
}

}  // namespace

void addApply(CLI::App& app, Action& action, InterruptWatch& watch) {
  CLI::App* subcommand = app.add_subcommand(
      "apply", "Deform another mesh, point cloud, VTK data set or glTF model as a project deforms its own");
  const auto command = std::make_shared<ApplyCommand>();
  subcommand->add_option("PROJECT", command->project, "The project (PBFFD)")->required();
  subcommand->add_option("MESH", command->source, "What to deform: " + applicableEndings())->required();
  subcommand->add_option("-o,--output", command->target, "The file to write, in the format of MESH")
      ->required()
      ->type_name("OUT");
  subcommand
      ->add_option("--align", command->align,
                   "Fit place, size and turn of MESH to the project's mesh first: none, similarity")
      ->check(CLI::IsMember({"none", "similarity"}))
      ->capture_default_str();
  subcommand
      ->add_option(
          "--transport", command->transports,
          "A VTK array of vectors or normals that turns along: NAME, NAME:vector or NAME:normal; may be "
          "given more than once")
      ->type_name("NAME")
      ->allow_extra_args(false);
  subcommand->callback([command, &action, &watch] {
    action = [command, &watch](const Progress& progress) { applyProject(*command, watch, progress); };
  });
}

}  // namespace pbffd::cli
