#include "app/dataset/staged_files.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace pbffd {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const fs::path& path, const std::error_code& code) {
  throw IoError(format("Could not write {}: {}. Choose another place, or see to its permissions and space.",
                       path.string(), code.message()));
}

/// A link is followed, so that writing through it does not replace it.
fs::path resolved(const fs::path& path) {
  std::error_code notThere;
  const fs::path whole = fs::canonical(path, notThere);
  if (notThere) {
    return path;
  }
  if (!fs::is_regular_file(whole)) {
    throw IoError(
        format("Could not write {}: it is there and is no regular file. Choose another name.", path.string()));
  }
  return whole;
}

}  // namespace

StagedFiles::StagedFiles(const fs::path& beside) : ownsFolder_(true) {
  const fs::path target = resolved(beside);
  const fs::path parent = target.parent_path().empty() ? fs::path(".") : target.parent_path();
  std::string pattern = (parent / format(".{}.XXXXXX", target.filename().string())).string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    fail(beside, std::error_code(errno, std::generic_category()));
  }
  folder_ = pattern;
}

StagedFiles::StagedFiles(const Shared& shared)
    : folder_(shared.folder), name_(shared.name), ownsFolder_(false) {}

StagedFiles::~StagedFiles() {
  std::error_code ignored;
  if (ownsFolder_) {
    fs::remove_all(folder_, ignored);
    return;
  }
  for (const File& file : files_) {
    fs::remove(file.staged, ignored);
  }
}

fs::path StagedFiles::add(const fs::path& target) {
  const fs::path staged = folder_ / format("{}{}{}", name_, files_.size(), target.extension().string());
  files_.push_back({staged, resolved(target)});
  return staged;
}

void StagedFiles::commit() {
  for (const File& file : files_) {
    std::error_code code;
    if (const fs::path parent = file.target.parent_path(); !parent.empty()) {
      fs::create_directories(parent, code);
    }
    if (!code && fs::exists(file.target)) {
      fs::permissions(file.staged, fs::status(file.target).permissions(), code);
    }
    if (!code) {
      fs::rename(file.staged, file.target, code);
    }
    if (code) {
      fail(file.target, code);
    }
  }
  files_.clear();
}

}  // namespace pbffd
