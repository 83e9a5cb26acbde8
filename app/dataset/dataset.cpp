#include "app/dataset/dataset.h"

#include "app/dataset/gltf_dataset.h"
#include "app/dataset/mesh_dataset.h"
#include "app/dataset/raw_xml_dataset.h"
#include "app/dataset/vtk_dataset.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/mesh/io/mesh_io.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace pbffd {
namespace {

constexpr std::array<std::string_view, 4> meshEndings{".obj", ".off", ".ply", ".stl"};
constexpr std::array<std::string_view, 4> vtkEndings{".vtu", ".vtp", ".vts", ".vtk"};
constexpr std::array<std::string_view, 2> gltfEndings{".glb", ".gltf"};

template <class Endings>
bool isOneOf(const std::string& ending, const Endings& endings) {
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

}  // namespace

std::string endingOf(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool isVtkDataset(const std::filesystem::path& path) {
  return isOneOf(endingOf(path), vtkEndings);
}

bool isDataset(const std::filesystem::path& path) {
  return formatOfEnding(path) != MeshFormat::none || isVtkDataset(path) || isOneOf(endingOf(path), gltfEndings);
}

std::vector<std::string_view> datasetEndings() {
  std::vector<std::string_view> endings(meshEndings.begin(), meshEndings.end());
  endings.insert(endings.end(), vtkEndings.begin(), vtkEndings.end());
  endings.insert(endings.end(), gltfEndings.begin(), gltfEndings.end());
  return endings;
}

std::string listed(const std::vector<std::string_view>& endings) {
  std::string text;
  for (std::size_t i = 0; i < endings.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < endings.size() ? ", " : " and ");
    text += endings[i];
  }
  return text;
}

std::unique_ptr<Dataset> openDataset(const std::filesystem::path& path, const Progress& progress) {
  const std::string ending = endingOf(path);
  if (formatOfEnding(path) != MeshFormat::none) {
    return openMeshDataset(path, progress);
  }
  if (isOneOf(ending, gltfEndings)) {
    return openGltfDataset(path, progress);
  }
  if (!isVtkDataset(path)) {
    throw InvalidInput(format("Could not read {}: its ending names no format with points. Known are {}.",
                              path.string(), listed(datasetEndings())));
  }
  if (auto raw = openRawXmlDataset(path, progress)) {
    return raw;
  }
  return openVtkDataset(path, progress);
}

bool isWritableAs(const std::filesystem::path& source, const std::filesystem::path& target) {
  return formatOfEnding(source) != MeshFormat::none ? formatOfEnding(target) != MeshFormat::none
                                                    : endingOf(source) == endingOf(target);
}

void requireSameEnding(const std::filesystem::path& source, const std::filesystem::path& target) {
  if (endingOf(source) != endingOf(target)) {
    throw InvalidInput(format("Could not write {}: {} keeps its format, so the output must end in {} too.",
                              target.string(), source.string(), endingOf(source)));
  }
}

Remark keptNormalsRemark(const std::filesystem::path& path, const std::string& normals) {
  return {format("The normals '{}' of {} were kept as they are. Name them among the arrays to turn along, and "
                 "they follow.",
                 normals, path.string()),
          "--transport " + normals};
}

void failForMissingArray(const std::filesystem::path& path, const Transport& transport,
                         const std::string& why) {
  throw InvalidInput(
      format("Could not transport the array '{}' of {}: {}", transport.array, path.string(), why));
}

}  // namespace pbffd
