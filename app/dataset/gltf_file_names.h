#pragma once

#include "app/dataset/gltf_document.h"

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace pbffd {

/// Gives the changed buffers of a model names beside its new file that take no other file's place: neither one
/// that the model names nor one that lies there already, unless the new file replaces that file's own model.
class GltfFileNames {
 public:
  GltfFileNames(const GltfDocument& source, const std::filesystem::path& target);

  /// "name.bin", "name_1.bin", ...
  std::string nameFor(std::size_t buffer);

 private:
  bool isFree(const std::string& name, std::size_t buffer) const;

  std::filesystem::path source_;
  std::filesystem::path target_;
  bool isInPlace_;
  std::vector<std::string> images_;
  std::vector<std::string> buffers_;
  std::set<std::string> replaced_;  ///< files of the buffers of the model that the target replaces
  std::set<std::string> given_;
};

}  // namespace pbffd
