#pragma once

#include "core/base/progress.h"
#include "core/project/project.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pbffd::ui {

/// The deformation of other files, which reads formats that the window knows nothing of: the program that makes
/// the window hands it over. Empty functions: there is none.
struct ApplyService {
  struct Request {
    std::filesystem::path source;
    std::filesystem::path target;
    bool align = false;  ///< fit place, size and turn of the source to the project's mesh first
    std::vector<std::string> transports;  ///< arrays that turn along: NAME, NAME:vector, NAME:normal
  };
  struct Report {
    std::int64_t points = 0;
    std::size_t pieces = 1;
    std::vector<std::string> remarks;  ///< what the user should know, a sentence each
  };

  /// Called on a worker thread. Throws Error, Cancelled; the target is then untouched.
  std::function<Report(const Project& project, const Request& request, const Progress& progress)> apply;
  /// Whether the ending is one that can be read.
  std::function<bool(const std::filesystem::path& path)> knows;
  /// Whether what is read from `source` can be written under the ending of `target`.
  std::function<bool(const std::filesystem::path& source, const std::filesystem::path& target)> fits;
  /// Whether files of this ending have arrays by name.
  std::function<bool(const std::filesystem::path& path)> hasArrays;
  /// ".obj, .vtu and .glb": for messages.
  std::string endings;

  explicit operator bool() const { return apply != nullptr; }
};

}  // namespace pbffd::ui
