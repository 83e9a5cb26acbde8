#pragma once

#include "core/base/progress.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace pbffd {

/// A file that is read or written at any place. Every failure throws IoError that names the file (by the name
/// given for messages) and the reason.
class RawFile {
 public:
  static RawFile forReading(const std::filesystem::path& path);
  /// Made anew; called `name` in messages.
  static RawFile forWriting(const std::filesystem::path& path, const std::filesystem::path& name);
  ~RawFile();
  RawFile(RawFile&& other) noexcept;
  RawFile& operator=(RawFile&&) = delete;

  /// Fills `bytes` from `at` on.
  void read(std::uint64_t at, std::span<char> bytes) const;
  void write(std::uint64_t at, std::string_view bytes);

  /// Throws what some file systems say of a full disk only then. Nothing may follow.
  void close();

  /// Makes `path`, called `name` in messages, a copy of `source`. Throws Cancelled.
  static void copyWhole(const std::filesystem::path& source, const std::filesystem::path& path,
                        const std::filesystem::path& name, const Progress& progress);

  /// Writes source's bytes [from, end) at `at`. Throws Cancelled.
  void copy(const RawFile& source, std::uint64_t from, std::uint64_t end, std::uint64_t at,
            const Progress& progress);

 private:
  RawFile(int descriptor, std::filesystem::path name) : descriptor_(descriptor), name_(std::move(name)) {}
  /// Lets the disk begin with these bytes, so that less is left to wait for at the end.
  void beginWriting(std::uint64_t at, std::uint64_t bytes) const;
  bool copyInKernel(const RawFile& source, std::uint64_t from, std::uint64_t at, std::uint64_t bytes);

  int descriptor_;
  std::filesystem::path name_;
};

}  // namespace pbffd
