#pragma once

#include "core/project/archive.h"
#include "core/project/project.h"

#include <map>
#include <string>
#include <vector>

namespace pbffd {

/// What a project file held that this program does not know, as JSON texts of objects with the unknown keys
/// alone, each empty where there were none. Points are found again by their identifiers.
struct ForeignContent {
  std::string root;  ///< "constraints", "curves", "poses" and "view" among them
  std::string mesh;
  std::string basis;
  std::string master;
  std::vector<std::string> levels;  ///< one a level, the coarsest first
  std::map<PointId, std::string> points;
  std::vector<ArchiveMember> members;  ///< in their order
};

}  // namespace pbffd
