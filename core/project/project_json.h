#pragma once

#include "core/base/error.h"
#include "core/project/foreign_content.h"
#include "core/project/json_reader.h"
#include "core/project/project.h"

// project.json (contract.md, section 3) as a value; private to the .cpp files of this folder.

namespace pbffd {

/// What project.json says beside the mesh's own bytes.
struct ProjectDocument {
  Project project;  ///< without its mesh
  std::string meshMember;
  std::string meshDigest;
  std::string view;  ///< the "view" object, or nothing
};

/// Reads the document of the present version. `foreign` of the project holds its unknown keys. Throws
/// InvalidInput that begins with the place of what is wrong: "/levels/0/points/3/rest/axes: ...".
ProjectDocument documentFrom(const Json& json);

/// The document of a project: known keys, then what its foreign content adds to them.
Json toJson(const ProjectDocument& document);

/// The document is of a version that this program does not know; the message is the whole one.
class NewerVersion : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
};

/// Brings a document of an older version to the present one, step by step. Throws InvalidInput for one that is
/// no project, NewerVersion for one of a newer version; `name` is the file's.
Json migrated(Json json, const std::string& name);

}  // namespace pbffd
