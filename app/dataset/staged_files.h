#pragma once

#include <filesystem>
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

  /// Where to write what will be `target`.
  std::filesystem::path add(const std::filesystem::path& target);

  /// Writes what will be `target`. Throws IoError that names that.
  void write(const std::filesystem::path& target, std::string_view bytes);

  /// Gives the files their names, in the order in which they were added; makes the folders that they need.
  /// Throws IoError that names the file.
  void commit();

 private:
  struct File {
    std::filesystem::path staged;
    std::filesystem::path target;
  };

  std::filesystem::path folder_;
  std::string name_;
  bool ownsFolder_;
  std::vector<File> files_;
};

/// Removes a folder of staged files, while other processes may be removing from it too.
void removeStaged(const std::filesystem::path& folder);

}  // namespace pbffd
