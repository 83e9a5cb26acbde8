#include "tests/structure/include_rules.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <sstream>

namespace pbffd::test {
namespace {

using Folders = std::vector<std::string_view>;

/// A folder, and the layers whose headers its files may include besides their own.
struct Layer {
  std::string_view folder;
  Folders below;
};

Folders joined(Folders first, const Folders& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Folders that lie in others stand before them.
const std::vector<Layer>& layers() {
  static const Folders space{"core/base", "core/mesh", "core/ffd"};
  static const Folders weighted = joined(space, {"core/ffd/weights"});
  static const Folders placed = joined(weighted, {"core/ffd/deform", "core/ffd/placement"});
  static const Folders core =
      joined(placed, {"core/ffd/levels", "core/ffd/refinement", "core/mesh/io", "core/project"});
  static const Folders uiCore = joined(core, {"ui/document"});
  static const Folders uiShown = joined(uiCore, {"ui/models", "ui/views"});
  static const Folders uiAll = joined(uiShown, {"ui/controllers"});
  static const std::vector<Layer> all{
      {"core/base", {}},
      {"core/mesh/io", {"core/base", "core/mesh"}},
      {"core/mesh", {"core/base"}},
      {"core/ffd/weights", space},
      {"core/ffd/deform", weighted},
      {"core/ffd/placement", weighted},
      {"core/ffd/levels", placed},
      {"core/ffd/refinement", placed},
      {"core/ffd", {"core/base", "core/mesh"}},
      {"core/project", core},
      {"ui/document", core},
      {"ui/models", uiCore},
      {"ui/views", uiCore},
      {"ui/controllers", uiShown},
      {"ui/window", uiAll},
      {"app/dataset", core},
      {"app/apply_mpi", joined(core, {"app/dataset"})},
      {"app/yardsticks", weighted},
      {"app/cli", joined(core, {"app/dataset", "app/yardsticks"})},
      {"app/workbench", joined(uiAll, {"ui/window", "app/dataset"})},
  };
  return all;
}

/// A library by its headers, and the only files that may include it (beginnings of their paths).
struct Library {
  std::string_view name;
  std::regex header;
  Folders allowedIn;
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> all{
      {"VTK", std::regex("vtk.*|QVTK.*"), {"ui/views/", "app/dataset/", "app/apply_mpi/ranks.cpp"}},
      {"Qt", std::regex("Q[A-Zt].*|q[a-z]+\\.h"), {"ui/", "app/workbench/"}},
      {"Qhull", std::regex("libqhull.*"), {"core/mesh/qhull_delaunay.cpp"}},
      {"OpenMesh", std::regex("OpenMesh/.*"), {"core/mesh/topology.cpp"}},
      {"nanoflann", std::regex("nanoflann.*"), {"core/mesh/nearest.cpp"}},
      {"TBB", std::regex("(oneapi/)?tbb(/.*|\\.h)"), {"core/base/parallel.cpp"}},
      {"OpenSSL", std::regex("openssl/.*"), {"core/base/file.cpp"}},
      {"fmt", std::regex("fmt/.*"), {"core/base/text.h"}},
      {"libzip", std::regex("zip(conf)?\\.h"), {"core/project/project_file", "core/project/archive"}},
      {"nlohmann-json", std::regex("nlohmann/.*"), {"core/project/", "app/cli/", "app/dataset/gltf_"}},
      {"CLI11", std::regex("CLI/.*"), {"app/cli/", "app/apply_mpi/main.cpp"}},
      {"Eigen", std::regex("Eigen/.*"), {"core/", "ui/", "app/"}},
      // Headers of the standard have no ending, those of the system end in .h.
      {"the standard library", std::regex("[a-z_0-9]+"), {"core/", "ui/", "app/"}},
      {"the system",
       std::regex("sys/[a-z]+\\.h|(fcntl|unistd|signal|pthread|dlfcn|malloc|immintrin|cpuid)\\.h"),
       {"core/", "ui/", "app/"}},
  };
  return all;
}

bool isIn(std::string_view path, std::string_view folder) {
  return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

const Layer* layerOf(std::string_view path) {
  const auto found = std::find_if(layers().begin(), layers().end(),
                                  [&](const Layer& layer) { return isIn(path, layer.folder); });
  return found == layers().end() ? nullptr : &*found;
}

/// Why `layer` may not include the project's own header; nothing where it may.
std::optional<std::string> faultOfOwn(const Layer& layer, const std::string& header) {
  static const std::regex generated("[a-z_0-9]+\\.moc");
  if (std::regex_match(header, generated)) {
    return std::nullopt;
  }
  const Layer* other = layerOf(header);
  if (other == nullptr) {
    return "is not named from the root of the sources, or lies in no layer";
  }
  const Folders& below = layer.below;
  if (other == &layer || std::find(below.begin(), below.end(), other->folder) != below.end()) {
    return std::nullopt;
  }
  return "lies in " + std::string(other->folder) + ", which " + std::string(layer.folder) + " may not look at";
}

/// Why `path` may not include the header of a library; nothing where it may.
std::optional<std::string> faultOfForeign(std::string_view path, const std::string& header) {
  const auto library = std::find_if(libraries().begin(), libraries().end(), [&](const Library& candidate) {
    return std::regex_match(header, candidate.header);
  });
  if (library == libraries().end()) {
    return "belongs to no library that the rules know";
  }
  const Folders& allowed = library->allowedIn;
  if (std::any_of(allowed.begin(), allowed.end(),
                  [&](std::string_view place) { return path.starts_with(place); })) {
    return std::nullopt;
  }
  return "belongs to " + std::string(library->name) + ", which stays elsewhere";
}

}  // namespace

std::vector<std::string> includeViolations(std::string_view path, std::string_view source) {
  static const std::regex include(R"(\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  const Layer* layer = layerOf(path);
  if (layer == nullptr) {
    return {std::string(path) + " lies in no layer."};
  }
  std::vector<std::string> violations;
  std::istringstream lines{std::string(source)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch match;
    if (!std::regex_match(line, match, include)) {
      continue;
    }
    const std::string header = match[2];
    const auto fault = match[1] == "<" ? faultOfForeign(path, header) : faultOfOwn(*layer, header);
    if (fault) {
      violations.push_back(std::string(path) + ":" + std::to_string(number) + ": " + header + " " + *fault +
                           ".");
    }
  }
  return violations;
}

}  // namespace pbffd::test
