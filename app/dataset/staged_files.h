#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace pbffd {

/// Files that are written elsewhere and get their final names together, once all are whole: an output of
/// many files is there as a whole or not at all. The elsewhere is a hidden folder beside the first file.
class StagedFiles {
 public:
  /// beside: the file, or one of the files, that will be written. Throws IoError that names it where the
  /// folder cannot be written to, or where it is there and no regular file.
  explicit StagedFiles(const std::filesystem::path& beside);
  /// Removes everything that was not committed.
  ~StagedFiles();
  StagedFiles(const StagedFiles&) = delete;
  StagedFiles& operator=(const StagedFiles&) = delete;

  /// Another process's part in the same folder; `name` keeps their files apart. The one that made the folder
  /// removes it.
  struct Shared {
    std::filesystem::path folder;
    std::string name;
  };
  explicit StagedFiles(const Shared& shared);

  const std::filesystem::path& folder() const { return folder_; }

  /// Where to write what will be `target`. Throws IoError that names it where it could not get its name later:
  /// its folder cannot be written to, or lies on another file system than the others.
  std::filesystem::path add(const std::filesystem::path& target);

  /// Writes what will be `target`. Throws IoError that names that.
  void write(const std::filesystem::path& target, std::string_view bytes);

  /// Makes the folders that the files need, and waits until the disk has them all, so that no power cut leaves
  /// less under a final name. Throws IoError that names the file; nothing has its final name then.
  void prepare();

  /// Prepares, unless that is done, and gives the files their names, in the order in which they were added.
  void commit();

 private:
  struct File {
    std::filesystem::path staged;
    std::filesystem::path target;
  };

  void requireNameable(const File& file, const std::filesystem::path& name);

  std::filesystem::path folder_;
  std::string name_;
  bool ownsFolder_;
  bool isPrepared_ = false;
  std::vector<File> files_;
  std::set<std::filesystem::path> nameable_;  ///< folders that were tried
};

/// Removes a folder of staged files, while other processes may be removing from it too.
void removeStaged(const std::filesystem::path& folder);

}  // namespace pbffd
