#pragma once

#include "app/dataset/field_transport.h"
#include "app/dataset/remark.h"
#include "core/base/progress.h"
#include "core/project/project.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace pbffd {

/// How a project's deformation is applied to another file.
struct ApplyOptions {
  /// Fit place, size and turn of the other mesh to the project's first (alignSimilar).
  bool align = false;
  /// The arrays of a VTK data set that turn along.
  std::vector<Transport> transports;
  /// Told the folder in which the output is made, for who may end the program before it is done.
  std::function<void(const std::filesystem::path& folder)> staging;
};

struct ApplyReport {
  std::int64_t points = 0;
  std::size_t pieces = 1;
  bool hasMoved = false;        ///< whether any point is elsewhere now
  std::vector<Remark> remarks;  ///< what the user should know
};

/// Writes `source` as `target` with its points where the project's deformation takes them: another mesh, a
/// point cloud, a VTK data set, whole or partitioned, a glTF model (contract, sections 1 and 4). What knows no
/// point stays as it is; a file of which no point moved keeps its very bytes. The target appears when it is
/// whole, of a partitioned one the index last. Throws InvalidInput, IoError that name the file and the piece;
/// Cancelled; the target is then untouched.
ApplyReport applyToFile(const Project& project, const std::filesystem::path& source,
                        const std::filesystem::path& target, const ApplyOptions& options = {},
                        const Progress& progress = {});

/// The endings that applyToFile() reads, for messages and file dialogs: ".obj, .off, ... and .pvtp".
std::string applicableEndings();
bool isApplicable(const std::filesystem::path& path);
/// Whether applyToFile() can write what it reads from `source` under the ending of `target`.
bool isApplicableAs(const std::filesystem::path& source, const std::filesystem::path& target);
/// Whether files of this ending have arrays by name, which ApplyOptions::transports can name.
bool hasNamedArrays(const std::filesystem::path& path);

}  // namespace pbffd
