#include "app/dataset/gltf_file_names.h"

#include "app/dataset/gltf_text.h"
#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <system_error>

namespace pbffd {
namespace fs = std::filesystem;
namespace {

/// The files that the entries of a list name, relative to the model; empty for data in the model itself.
std::vector<std::string> filesOf(const GltfDocument& document, const char* list) {
  return document.guarded([&] {
    std::vector<std::string> files;
    for (const auto& entry : document.list(list)) {
      const std::string uri = entry.value("uri", std::string());
      files.push_back(uri.starts_with("data:") ? std::string()
                                               : fs::path(fromUri(uri)).lexically_normal().generic_string());
    }
    return files;
  });
}

/// The files of the buffers of the model at `path`; none where there is no such model.
std::set<std::string> bufferFilesAt(const fs::path& path) {
  std::error_code notThere;
  if (!fs::exists(path, notThere)) {
    return {};
  }
  try {
    const std::vector<std::string> files = filesOf(GltfDocument(path), "buffers");
    return {files.begin(), files.end()};
  } catch (const InvalidInput&) {
    return {};
  } catch (const IoError&) {
    return {};
  }
}

}  // namespace

GltfFileNames::GltfFileNames(const GltfDocument& source, const fs::path& target)
    : source_(source.path()),
      target_(target),
      images_(filesOf(source, "images")),
      buffers_(filesOf(source, "buffers")),
      replaced_(bufferFilesAt(target)) {
  std::error_code notThere;
  isInPlace_ = fs::equivalent(source_, target_, notThere);
}

std::string GltfFileNames::nameFor(std::size_t buffer) {
  const std::string stem = target_.stem().string();
  std::string name = stem + ".bin";
  for (int number = 1; !isFree(name, buffer); ++number) {
    name = format("{}_{}.bin", stem, number);
  }
  given_.insert(name);
  return name;
}

bool GltfFileNames::isFree(const std::string& name, std::size_t buffer) const {
  if (given_.contains(name) || std::find(images_.begin(), images_.end(), name) != images_.end()) {
    return false;
  }
  std::error_code notThere;
  const fs::path file = target_.parent_path() / name;
  const bool isOfSource = !isInPlace_ && fs::equivalent(source_.parent_path() / name, file, notThere);
  for (std::size_t b = 0; b < buffers_.size(); ++b) {
    if (buffers_[b] == name && (b != buffer || isOfSource)) {
      return false;
    }
  }
  return !fs::exists(file, notThere) || replaced_.contains(name);
}

}  // namespace pbffd
