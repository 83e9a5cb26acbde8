#include "core/project/edit.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/edit_functions.h"

namespace pbffd {
namespace {

/// "edit 3 (move, at /2): " and what is wrong with it.
[[noreturn]] void failAt(std::size_t place, const Edit& edit, const char* within, const char* why) {
  throw InvalidInput(format("{} {} ({}, at /{}): {}", within, place + 1, nameOf(edit), place, why));
}

/// What is written has to be read again: the reader takes no identifier that other programs would round.
void requireIdentifiers(const Project& project) {
  if (project.nextId > greatestPointId) {
    throw InvalidInput(format(
        "the identifiers are used up: the next one would be {}, above the greatest, {}; give smaller ones",
        project.nextId, greatestPointId));
  }
}

/// The edits one after the other; `what` names one in messages.
Project appliedInOrder(const EditScope& scope, const std::vector<Edit>& edits, const char* what) {
  Project project = scope.before;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    scope.progress.throwIfCancelled();
    const Project current = project;
    try {
      project = std::visit(
          [&](const auto& edit) {
            return applied({current, scope.workspace, scope.progress, scope.remarks}, edit);
          },
          edits[i].value());
      requireIdentifiers(project);
    } catch (const InvalidInput& error) {
      failAt(i, edits[i], what, error.what());
    }
  }
  return project;
}

}  // namespace

Project applied(const EditScope& scope, const Group& edit) {
  if (edit.edits.empty()) {
    throw InvalidInput("the group holds no edits");
  }
  return appliedInOrder(scope, edit.edits, "its edit");
}

EditResult apply(const Project& project, const Edit& edit, EditWorkspace& workspace, const Progress& progress) {
  progress.throwIfCancelled();
  EditResult result;
  const EditScope scope{project, workspace, progress, result.remarks};
  result.project = std::visit([&](const auto& one) { return applied(scope, one); }, edit.value());
  requireIdentifiers(result.project);
  return result;
}

EditResult applyAll(const Project& project, const std::vector<Edit>& edits, EditWorkspace& workspace,
                    const Progress& progress) {
  EditResult result;
  result.project = appliedInOrder({project, workspace, progress, result.remarks}, edits, "edit");
  return result;
}

std::string_view nameOf(const Edit& edit) {
  struct Names {
    std::string_view operator()(const Place&) const { return "place"; }
    std::string_view operator()(const Move&) const { return "move"; }
    std::string_view operator()(const Transform&) const { return "transform"; }
    std::string_view operator()(const SetPose&) const { return "set_pose"; }
    std::string_view operator()(const SetRegion&) const { return "set_region"; }
    std::string_view operator()(const Add&) const { return "add"; }
    std::string_view operator()(const Remove&) const { return "remove"; }
    std::string_view operator()(const Enable&) const { return "enable"; }
    std::string_view operator()(const Lock&) const { return "lock"; }
    std::string_view operator()(const Strength&) const { return "strength"; }
    std::string_view operator()(const SetReach&) const { return "reach"; }
    std::string_view operator()(const Refine&) const { return "refine"; }
    std::string_view operator()(const Rename&) const { return "rename"; }
    std::string_view operator()(const SetLevels&) const { return "levels"; }
    std::string_view operator()(const SetMaster&) const { return "master"; }
    std::string_view operator()(const SetKernel&) const { return "kernel"; }
    std::string_view operator()(const Reset&) const { return "reset"; }
    std::string_view operator()(const Group&) const { return "group"; }
  };
  return std::visit(Names{}, edit.value());
}

}  // namespace pbffd
