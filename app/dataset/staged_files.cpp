#include "app/dataset/staged_files.h"

#include "app/dataset/raw_file.h"
#include "core/base/file.h"
#include "core/base/text.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace pbffd {
namespace fs = std::filesystem;
StagedFiles::StagedFiles(const fs::path& beside) : ownsFolder_(true) {
  const fs::path target = writeTarget(beside);
  const fs::path parent = target.parent_path().empty() ? fs::path(".") : target.parent_path();
  std::string pattern = (parent / format(".{}.XXXXXX", target.filename().string())).string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    failToWrite(beside, errno);
  }
  folder_ = pattern;
}

StagedFiles::StagedFiles(const Shared& shared)
    : folder_(shared.folder), name_(shared.name), ownsFolder_(false) {}

StagedFiles::~StagedFiles() {
  std::error_code ignored;
  if (ownsFolder_) {
    removeStaged(folder_);
    return;
  }
  for (const File& file : files_) {
    fs::remove(file.staged, ignored);
  }
}

fs::path StagedFiles::add(const fs::path& target) {
  const fs::path staged = folder_ / format("{}{}{}", name_, files_.size(), target.extension().string());
  files_.push_back({staged, writeTarget(target)});
  return staged;
}

void StagedFiles::write(const fs::path& target, std::string_view bytes) {
  RawFile file = RawFile::forWriting(add(target), target);
  file.write(0, bytes);
  file.close();
}

void removeStaged(const fs::path& folder) {
  // It gives up where a file that it listed is gone; what is left is less each time.
  constexpr int mostTries = 100;
  std::error_code failure;
  for (int tries = 0; tries < mostTries && fs::exists(folder, failure); ++tries) {
    fs::remove_all(folder, failure);
  }
}

void StagedFiles::commit() {
  std::error_code code;
  const auto require = [&code](const File& file) {
    if (code) {
      failToWrite(file.target, code.value());
    }
  };
  // What can fail goes first: from the first new name on, only names are given.
  for (const File& file : files_) {
    if (const fs::path parent = file.target.parent_path(); !parent.empty()) {
      fs::create_directories(parent, code);
    }
    if (!code && fs::exists(file.target, code)) {
      fs::permissions(file.staged, fs::status(file.target).permissions(), code);
    }
    require(file);
  }
  for (const File& file : files_) {
    fs::rename(file.staged, file.target, code);
    require(file);
  }
  files_.clear();
}

}  // namespace pbffd
