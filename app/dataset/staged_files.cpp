#include "app/dataset/staged_files.h"

#include "app/dataset/raw_file.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <system_error>

namespace pbffd {
namespace fs = std::filesystem;
namespace {

/// The folder itself, or the one in which it will be made.
fs::path existingFolder(fs::path folder) {
  std::error_code ignored;
  while (!folder.empty() && !fs::exists(folder, ignored)) {
    folder = folder.parent_path();
  }
  return folder.empty() ? fs::path(".") : folder;
}

}  // namespace

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
  const File file{staged, writeTarget(target)};
  requireNameable(file, target);
  files_.push_back(file);
  isPrepared_ = false;
  return staged;
}

void StagedFiles::requireNameable(const File& file, const fs::path& name) {
  const fs::path folder = existingFolder(file.target.parent_path());
  if (!nameable_.insert(folder).second) {
    return;
  }
  // Only a new name tells: mounts of one disk have one number, and still no file goes from one to the other.
  const fs::path trial = folder / format("{}{}trial", folder_.filename().string(), name_);
  RawFile::forWriting(file.staged, name).close();
  if (::rename(file.staged.c_str(), trial.c_str()) == 0) {
    ::unlink(trial.c_str());
    return;
  }
  const int code = errno;
  ::unlink(file.staged.c_str());
  if (code != EXDEV) {
    failToWrite(name, code);
  }
  throw IoError(
      format("Could not write {}: it lies on another file system than {}, and the files of one output appear "
             "together. Choose places on one file system.",
             name.string(), folder_.parent_path().string()));
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

// What can fail goes first: from the first new name on, only names are given.
void StagedFiles::prepare() {
  std::error_code code;
  for (const File& file : files_) {
    if (const fs::path parent = file.target.parent_path(); !parent.empty()) {
      fs::create_directories(parent, code);
    }
    if (!code && fs::exists(file.target, code)) {
      fs::permissions(file.staged, fs::status(file.target).permissions(), code);
    }
    if (code) {
      failToWrite(file.target, code.value());
    }
    synchronize(file.staged, file.target);
  }
  isPrepared_ = true;
}

void StagedFiles::commit() {
  if (!isPrepared_) {
    prepare();
  }
  for (const File& file : files_) {
    std::error_code code;
    fs::rename(file.staged, file.target, code);
    if (code) {
      failToWrite(file.target, code.value());
    }
  }
  files_.clear();
}

}  // namespace pbffd
