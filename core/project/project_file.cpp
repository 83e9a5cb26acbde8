#include "core/project/project_file.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/ffd/levels/binding.h"
#include "core/mesh/io/mesh_io.h"
#include "core/project/archive.h"
#include "core/project/json_text.h"
#include "core/project/project_json.h"

#include <algorithm>

namespace pbffd {
namespace {

constexpr const char* documentName = "project.json";
constexpr const char* thumbnailName = "thumbnail.png";

[[noreturn]] void failToOpen(const std::filesystem::path& path, const std::string& why) {
  throw InvalidInput(
      format("Could not open {}: {}. The file may be damaged, or written by another program; open an "
             "earlier version of it.",
             path.string(), why));
}

Json parsedDocument(const std::filesystem::path& path, const std::string& text) {
  try {
    return parsedJson(text);
  } catch (const JsonTextError& error) {
    failToOpen(path, format("{}, {}", documentName, error.what()));
  }
}

ProjectDocument readDocument(const std::filesystem::path& path, const Archive& archive) {
  const ArchiveMember* member = archive.find(documentName);
  if (member == nullptr) {
    failToOpen(path, format("it is no project: there is no {} in it", documentName));
  }
  const Json json = parsedDocument(path, member->bytes);
  try {
    return documentFrom(migrated(json, path.string()));
  } catch (const NewerVersion&) {
    throw;
  } catch (const InvalidInput& error) {
    failToOpen(path, format("{}, {}", documentName, error.what()));
  }
}

std::shared_ptr<const RestMesh> readMeshMember(const std::filesystem::path& path,
                                               const ProjectDocument& document, Archive& archive,
                                               const Progress& progress) {
  const std::string& name = document.meshMember;
  const auto member = std::find_if(archive.members.begin(), archive.members.end(),
                                   [&](const ArchiveMember& one) { return one.name == name; });
  if (member == archive.members.end()) {
    failToOpen(path, format("its mesh {} is missing", name));
  }
  if (sha256(member->bytes) != document.meshDigest) {
    failToOpen(path,
               format("its mesh {} is not the one that the project was saved with (SHA-256 differs)", name));
  }
  auto bytes = std::make_shared<const std::string>(std::move(member->bytes));
  archive.members.erase(member);
  try {
    return std::make_shared<const RestMesh>(
        parseMesh(std::move(bytes), std::filesystem::path(name).filename().string(), progress));
  } catch (const InvalidInput& error) {
    throw InvalidInput(format("Could not open {}, for its mesh: {}", path.string(), error.what()));
  }
}

/// Bindings depend on the mesh, so that they can be looked at only when it has been read. Poses are what is
/// seen and exported: where the two differ they stay.
void mendLevels(const std::filesystem::path& path, LoadedProject& loaded, const Progress& progress) {
  try {
    const Index mended = mendBindings(*loaded.project.mesh, loaded.project.controls, progress);
    if (mended > 0) {
      loaded.remarks.push_back(format(
          "The levels did not fit together: {} point{} not where the binding to the next coarser level puts "
          "{}. The poses were kept.",
          mended, mended == 1 ? " was" : "s were", mended == 1 ? "it" : "them"));
    }
  } catch (const InvalidInput& error) {
    failToOpen(path, format("the levels do not fit together: {}", error.what()));
  }
}

/// A name that ZIP and JSON both can hold, without a folder.
std::string plainName(std::string name) {
  name = name.substr(name.find_last_of("/\\") + 1);
  try {
    static_cast<void>(Json(name).dump());
  } catch (const Json::exception&) {
    std::replace_if(
        name.begin(), name.end(), [](unsigned char letter) { return letter >= 0x80; }, '_');
  }
  return name.empty() || name == "." || name == ".." ? "mesh.obj" : name;
}

/// The imported file, or for a mesh that came from none one that is made of it.
ArchiveMember meshMember(const Mesh& mesh, const Progress& progress) {
  if (mesh.source.bytes) {
    return {"mesh/" + plainName(mesh.source.name), {}, true, mesh.source.bytes};
  }
  const std::string name =
      std::filesystem::path(plainName(mesh.source.name)).replace_extension(".obj").string();
  return {"mesh/" + name, encodeMesh(mesh, {mesh.positions, {}}, MeshFormat::obj, progress), true};
}

Archive archiveOf(const Project& project, const ProjectExtras& extras, const Progress& progress) {
  Archive archive;
  ArchiveMember mesh = meshMember(project.mesh->mesh(), progress);
  ProjectDocument document{project, mesh.name, sha256(mesh.content()), extras.viewJson};
  archive.members.push_back(
      {documentName, toJson(document).dump(-1, ' ', false, Json::error_handler_t::replace), true});
  archive.members.push_back(std::move(mesh));
  if (!extras.thumbnailPng.empty()) {
    archive.members.push_back({thumbnailName, extras.thumbnailPng, false});
  }
  if (project.foreign) {
    for (const ArchiveMember& member : project.foreign->members) {
      if (archive.find(member.name) == nullptr) {
        archive.members.push_back(member);
      }
    }
  }
  return archive;
}

}  // namespace

LoadedProject loadProject(const std::filesystem::path& path, const Progress& progress) {
  progress.report("Opening the project");
  Archive archive = readArchive(path, progress);
  ProjectDocument document = readDocument(path, archive);
  LoadedProject loaded;
  document.project.mesh = readMeshMember(path, document, archive, progress);
  loaded.extras.viewJson = std::move(document.view);
  if (const ArchiveMember* thumbnail = archive.find(thumbnailName)) {
    loaded.extras.thumbnailPng = thumbnail->bytes;
  }
  std::erase_if(archive.members, [](const ArchiveMember& member) { return member.name == documentName; });
  ForeignContent foreign = *document.project.foreign;
  foreign.members = std::move(archive.members);
  document.project.foreign = std::make_shared<const ForeignContent>(std::move(foreign));
  loaded.project = std::move(document.project);
  mendLevels(path, loaded, progress);
  return loaded;
}

void saveProject(const std::filesystem::path& path, const Project& project, const ProjectExtras& extras,
                 const Progress& progress) {
  progress.report("Saving the project");
  writeArchive(path, archiveOf(project, extras, progress), progress);
}

}  // namespace pbffd
