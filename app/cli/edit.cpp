#include "app/cli/commands.h"

#include "app/cli/files.h"
#include "app/cli/output.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/project/edit_json.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace pbffd::cli {
namespace {

struct EditCommand {
  std::filesystem::path project;
  std::string edits;  ///< a file, or "-" for standard input
  std::filesystem::path output;
};

std::string readStandardInput() {
  std::string text;
  std::array<char, 1 << 16> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), stdin)) {
    text.append(buffer.data(), count);
  }
  if (std::ferror(stdin) != 0) {
    throw IoError("Could not read the edits from standard input to their end.");
  }
  return text;
}

void edit(const EditCommand& command, const Progress& progress) {
  requireProjectName(command.output);
  const bool fromInput = command.edits == "-";
  const std::string name = fromInput ? "standard input" : command.edits;
  const std::vector<Edit> edits = parseEdits(fromInput ? readStandardInput() : readFile(command.edits), name);
  const LoadedProject loaded = openProject(command.project, progress);
  EditWorkspace workspace;
  const EditResult result = naming(name, [&] { return applyAll(loaded.project, edits, workspace, progress); });
  saveProject(command.output, result.project, loaded.extras, progress);
  printRemarks(result.remarks);
  print(format("{} {} in {}.\n", edits.size(), edits.size() == 1 ? "edit" : "edits", command.output.string()));
}

}  // namespace

void addEdit(CLI::App& app, Action& action) {
  CLI::App* subcommand = app.add_subcommand("edit", "Do edits of a JSON file in order, all of them or none");
  const auto command = std::make_shared<EditCommand>();
  subcommand->add_option("PROJECT", command->project, "The project (PBFFD)")->required();
  subcommand->add_option("--edits", command->edits, "The edits, a JSON array; - is standard input")
      ->required()
      ->type_name("FILE");
  subcommand->add_option("-o,--output", command->output, "The project to write; may be the one that is read")
      ->required()
      ->type_name("OUT");
  subcommand->callback(
      [command, &action] { action = [command](const Progress& progress) { edit(*command, progress); }; });
}

}  // namespace pbffd::cli
