#pragma once

#include "core/base/progress.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pbffd {

/// One member of a ZIP archive. A folder's name ends in '/'.
struct ArchiveMember {
  std::string name;
  std::string bytes;
  bool compressed = true;  ///< stored by deflate, else as it is
  /// What somebody else holds too, in place of `bytes`: a mesh file may be as long as all else in memory.
  std::shared_ptr<const std::string> shared = nullptr;

  const std::string& content() const { return shared ? *shared : bytes; }
};

/// The members of a ZIP archive, in order: the only user of libzip.
struct Archive {
  std::vector<ArchiveMember> members;

  /// The first of that name; nullptr for none.
  const ArchiveMember* find(const std::string& name) const;
};

/// Reads a whole archive. Throws IoError, or InvalidInput that names the file, the member and what is wrong:
/// no archive, cut off, a member that is damaged, encrypted, or larger unpacked than any project.
Archive readArchive(const std::filesystem::path& path, const Progress& progress = {});

/// Replaces `path` by the archive (replaceFile), without a copy of it in memory; the same bytes for the same
/// members. Throws IoError that names the file, Cancelled; `path` is then untouched.
void writeArchive(const std::filesystem::path& path, const Archive& archive, const Progress& progress = {});

}  // namespace pbffd
