#include "app/cli/commands.h"
#include "app/cli/files.h"
#include "app/cli/output.h"
#include "core/base/text.h"
#include "core/mesh/io/mesh_io.h"
#include "core/project/project_file.h"

#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

namespace pbffd::cli {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// The version of project files that this program writes, and reads every project as.
constexpr int projectVersion = 1;

struct InfoOptions {
  fs::path file;
  bool asJson = false;
};

/// By the ending, or else by how a ZIP archive begins: a project may be called anything.
bool isProject(const fs::path& path) {
  if (formatOfEnding(path) != MeshFormat::none) {
    return false;
  }
  std::array<char, 2> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return path.extension() == ".pbffd" || (start[0] == 'P' && start[1] == 'K');
}

Json toJson(const Vec3& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

std::map<Index, Index> facesBySize(const Polygons& faces) {
  std::map<Index, Index> count;
  for (Index f = 0; f < faces.size(); ++f) {
    ++count[static_cast<Index>(faces[f].size())];
  }
  return count;
}

Json describeMesh(const RestMesh& mesh) {
  const Topology& topology = mesh.topology();
  Json polygons = Json::object();
  for (const auto& [size, count] : facesBySize(mesh.mesh().faces)) {
    polygons[std::to_string(size)] = count;
  }
  Json attributes = Json::array();
  for (const Attribute& attribute : mesh.mesh().attributes) {
    attributes.push_back(attribute.name);
  }
  Json description{{"kind", "mesh"},
                   {"vertices", mesh.vertexCount()},
                   {"faces", mesh.mesh().faces.size()},
                   {"triangles", mesh.triangles().size()},
                   {"polygons", polygons},
                   {"components", topology.components},
                   {"boundary_edges", topology.boundaryEdges},
                   {"nonmanifold_edges", topology.nonmanifoldEdges},
                   {"isolated_vertices", topology.isolatedVertices},
                   {"closed", topology.isClosed},
                   {"bounds", Json::array({toJson(mesh.bounds().low), toJson(mesh.bounds().high)})},
                   {"attributes", attributes}};
  if (!mesh.mesh().remarks.empty()) {
    description["remarks"] = mesh.mesh().remarks;
  }
  return description;
}

Json describeProject(const Project& project) {
  Json levels = Json::array();
  int number = 0;
  for (const Level& level : project.controls.levels) {
    levels.push_back({{"level", ++number}, {"points", level.size()}});
  }
  const KeptCounts kept = keptCounts(project);
  return {{"kind", "project"},
          {"version", projectVersion},
          {"mesh", describeMesh(*project.mesh)},
          {"levels", levels},
          {"curves", kept.curves},
          {"constraints", kept.constraints},
          {"poses", kept.poses},
          {"history", 0}};
}

std::string row(std::string_view label, std::string_view value) {
  return format("  {:<20}{}\n", label, value);
}

std::string meshText(const Json& mesh) {
  const auto number = [&](const char* key) { return grouped(mesh[key].get<std::int64_t>()); };
  std::string sizes;
  for (const auto& [size, count] : mesh["polygons"].items()) {
    sizes += format("{}{} of {} corners", sizes.empty() ? "" : ", ", grouped(count.get<std::int64_t>()), size);
  }
  std::string attributes;
  for (const auto& name : mesh["attributes"]) {
    attributes += (attributes.empty() ? "" : ", ") + name.get<std::string>();
  }
  const auto point = [](const Json& p) {
    return format("{:.6g}, {:.6g}, {:.6g}", p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
  };
  return row("Vertices", number("vertices")) +
         row("Faces", number("faces") + (sizes.empty() ? "" : ": ") + sizes) +
         row("Triangles", number("triangles")) + row("Parts", number("components")) +
         row("Surface", mesh["closed"].get<bool>() ? "closed" : "open") +
         row("Boundary edges", number("boundary_edges")) +
         row("Non-manifold edges", number("nonmanifold_edges")) +
         row("Isolated vertices", number("isolated_vertices")) +
         row("Bounds", point(mesh["bounds"][0]) + "  to  " + point(mesh["bounds"][1])) +
         row("Attributes", attributes.empty() ? "none" : attributes);
}

std::string projectText(const Json& project) {
  std::string text;
  for (const auto& level : project["levels"]) {
    const auto points = level["points"].get<std::int64_t>();
    text += row(format("Level {}", level["level"].get<int>()),
                format("{} control point{}", grouped(points), points == 1 ? "" : "s"));
  }
  return text;
}

void info(const InfoOptions& options, const Progress& progress) {
  const Json description = isProject(options.file)
                               ? describeProject(openProject(options.file, progress).project)
                               : describeMesh(RestMesh(readMesh(options.file, progress)));
  if (options.asJson) {
    print(description.dump() + "\n");
    return;
  }
  const bool isMesh = description["kind"] == "mesh";
  const Json& mesh = isMesh ? description : description["mesh"];
  print(format("{}: a {}\n", options.file.string(), isMesh ? "mesh" : "project") +
        (isMesh ? "" : projectText(description)) + meshText(mesh));
  printRemarks(mesh.value("remarks", std::vector<std::string>()));
}

}  // namespace

void addInfo(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("info", "What a mesh or a project holds");
  const auto options = std::make_shared<InfoOptions>();
  command->add_option("FILE", options->file, "A mesh (OBJ, OFF, PLY, STL) or a project (PBFFD)")->required();
  command->add_flag("--json", options->asJson, "Print one JSON object");
  command->callback(
      [options, &action] { action = [options](const Progress& progress) { info(*options, progress); }; });
}

}  // namespace pbffd::cli
