#pragma once

#include "core/base/progress.h"
#include "core/project/project.h"

#include <filesystem>
#include <string>
#include <vector>

namespace pbffd {

/// What a project file carries beside the project itself.
struct ProjectExtras {
  std::string thumbnailPng;  ///< empty: none; on saving, an earlier one is then kept
  std::string viewJson;      ///< the "view" object; empty: none
};

struct LoadedProject {
  Project project;
  ProjectExtras extras;
  std::vector<std::string> remarks;  ///< sentences that the user should read
};

/// What a project file held that this version keeps for the next save, and does not use.
struct KeptCounts {
  int constraints = 0;
  int curves = 0;
  int poses = 0;
};
KeptCounts keptCounts(const Project& project);

/// Reads NAME.pbffd (contract.md, section 3). Throws IoError, or InvalidInput that names the file, the
/// member, what is wrong and what to try (a newer version: update the program).
LoadedProject loadProject(const std::filesystem::path& path, const Progress& progress = {});

/// Writes the whole file beside and renames it; a failure leaves what was there. Members and JSON keys
/// that this program did not know when it loaded the project are written back.
void saveProject(const std::filesystem::path& path, const Project& project, const ProjectExtras& extras = {},
                 const Progress& progress = {});

}  // namespace pbffd
