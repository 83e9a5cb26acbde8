#include "core/project/project_json.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/project/control_json.h"
#include "core/project/leftover.h"
#include "core/project/project_file.h"

#include <algorithm>
#include <limits>

namespace pbffd {
namespace {

constexpr int presentVersion = 1;

using Migration = void (*)(Json&);
/// Entry i takes a document of version i + 1 to version i + 2.
const std::vector<Migration>& migrations() {
  static const std::vector<Migration> all(presentVersion - 1);
  return all;
}

/// What is left of the document beside what this program writes itself.
ForeignContent foreignOf(const Json& json, const Json& known) {
  ForeignContent foreign;
  Json root = leftover(json, known);
  for (const char* part : {"mesh", "basis", "master", "levels"}) {
    root.erase(part);
  }
  foreign.root = textOf(root);
  foreign.mesh = textOf(leftover(json["mesh"], known["mesh"]));
  foreign.basis = textOf(leftover(json["basis"], known["basis"]));
  foreign.master = textOf(leftover(json["master"], known["master"]));
  for (std::size_t l = 0; l < json["levels"].size(); ++l) {
    const Json& level = json["levels"][l];
    foreign.levels.push_back(textOf(leftover(level, {{"points", nullptr}})));
    for (std::size_t i = 0; i < level["points"].size(); ++i) {
      Json point = known["levels"][l]["points"][i];
      // Written only where they say something, but known.
      point.emplace("merged_from", nullptr);
      point.emplace("binding", nullptr);
      const std::string text = textOf(leftover(level["points"][i], point));
      if (!text.empty()) {
        foreign.points[point["id"].get<PointId>()] = text;
      }
    }
  }
  return foreign;
}

void addForeign(Json& json, const ForeignContent& foreign) {
  overlay(json, foreign.root);
  overlay(json["mesh"], foreign.mesh);
  overlay(json["basis"], foreign.basis);
  overlay(json["master"], foreign.master);
  Json& levels = json["levels"];
  for (std::size_t l = 0; l < levels.size(); ++l) {
    // Levels have no identifier: they are the same where there are as many.
    if (foreign.levels.size() == levels.size()) {
      overlay(levels[l], foreign.levels[l]);
    }
    for (Json& point : levels[l]["points"]) {
      const auto found = foreign.points.find(point["id"].get<PointId>());
      if (found != foreign.points.end()) {
        overlay(point, found->second);
      }
    }
  }
}

PointId greatestId(const ControlSet& set) {
  PointId greatest = 0;
  for (const Level& level : set.levels) {
    for (const ControlPoint& point : level) {
      greatest = std::max(greatest, point.id);
    }
  }
  return greatest;
}

Json knownJson(const ProjectDocument& document) {
  const Project& project = document.project;
  Json json = controlsToJson(project.controls);
  json["format"] = "pbffd-project";
  json["version"] = presentVersion;
  json["next_id"] = project.nextId;
  json["mesh"] = {{"file", document.meshMember}, {"sha256", document.meshDigest}};
  json["placement"] = toJson(project.placement);
  return json;
}

int sizeOf(const Json& root, const char* list) {
  return root.contains(list) && root[list].is_array() ? static_cast<int>(root[list].size()) : 0;
}

}  // namespace

KeptCounts keptCounts(const Project& project) {
  if (!project.foreign || project.foreign->root.empty()) {
    return {};
  }
  const Json root = Json::parse(project.foreign->root);
  return {sizeOf(root, "constraints"), sizeOf(root, "curves"), sizeOf(root, "poses")};
}

ProjectDocument documentFrom(const Json& json) {
  const JsonReader reader(json, "");
  ProjectDocument document;
  const JsonReader mesh = reader.at("mesh");
  document.meshMember = mesh.at("file").string();
  document.meshDigest = mesh.at("sha256").string();
  Project& project = document.project;
  project.controls = controlsFrom(reader);
  if (reader.has("placement")) {
    const JsonReader placement = reader.at("placement");
    project.placement = placementFrom(placement);
  }
  project.nextId = std::max(reader.at("next_id").identifier(), greatestId(project.controls) + 1);
  if (reader.has("view")) {
    reader.at("view").requireObject();
    document.view = json["view"].dump();
  }
  for (const char* list : {"constraints", "curves", "poses"}) {
    if (reader.has(list)) {
      reader.at(list).size();
    }
  }
  project.foreign = std::make_shared<const ForeignContent>(foreignOf(json, knownJson(document)));
  return document;
}

Json toJson(const ProjectDocument& document) {
  Json json = knownJson(document);
  if (!document.view.empty()) {
    json["view"] = Json::parse(document.view);
  }
  if (document.project.foreign) {
    addForeign(json, *document.project.foreign);
  }
  for (const char* list : {"constraints", "curves", "poses"}) {
    json.emplace(list, Json::array());
  }
  return json;
}

Json migrated(Json json, const std::string& name) {
  const JsonReader reader(json, "");
  reader.requireObject();
  if (!reader.has("format") || reader.at("format").value() != "pbffd-project") {
    reader.fail("its \"format\" is not \"pbffd-project\"");
  }
  const std::int64_t version = reader.at("version").integer(1, std::numeric_limits<std::int64_t>::max());
  if (version > presentVersion) {
    throw NewerVersion(
        format("{} was made by a newer version (file version {}, this program reads {}). Update the "
               "program to open it.",
               name, version, presentVersion));
  }
  for (std::int64_t from = version; from < presentVersion; ++from) {
    migrations()[static_cast<std::size_t>(from - 1)](json);
    json["version"] = from + 1;
  }
  return json;
}

}  // namespace pbffd
