#pragma once

#include "app/dataset/field_transport.h"
#include "app/dataset/placed_space.h"
#include "app/dataset/remark.h"
#include "app/dataset/staged_files.h"
#include "core/base/progress.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pbffd {

/// How a data set is carried through a deformation.
struct Carrying {
  const PlacedSpace& space;
  std::vector<Transport> transports;
  Progress progress;
};

/// A file whose points a deformation can move, with everything else that it holds. Only what is asked for is
/// read.
class Dataset {
 public:
  virtual ~Dataset() = default;

  virtual std::int64_t pointCount() const = 0;

  /// Whether there are cells with a volume, which a reach of `connected` would tear (contract, section 4).
  virtual bool hasVolumeCells() const = 0;

  /// The points whose number in file order is a multiple of `stride`.
  virtual Points sample(std::int64_t stride) const = 0;

  /// Stages the deformed file under the name `target`, in the format of the source (of the ending, for
  /// meshes); where no point moved and the format stays, the very bytes of the source. Returns what the user
  /// should know. The data set is spent afterwards. Throws InvalidInput, IoError, Cancelled.
  virtual std::vector<Remark> write(const std::filesystem::path& target, StagedFiles& staged,
                                    const Carrying& carrying) = 0;
};

/// Whether `path` has an ending that openDataset() knows.
bool isDataset(const std::filesystem::path& path);

/// Whether it is the ending of a VTK data set.
bool isVtkDataset(const std::filesystem::path& path);

/// The endings that openDataset() knows.
std::vector<std::string_view> datasetEndings();

/// ".obj, .off and .vtu".
std::string listed(const std::vector<std::string_view>& endings);

/// By the ending: OBJ, OFF, PLY, STL, VTU, VTP, VTS, legacy VTK, GLB, glTF. Throws IoError, or InvalidInput
/// that names the file, the place in it, what is wrong and what to try; Cancelled.
std::unique_ptr<Dataset> openDataset(const std::filesystem::path& path, const Progress& progress = {});

/// The ending in lower case, with its dot.
std::string endingOf(const std::filesystem::path& path);

/// Whether what is read from `source` can be written under the ending of `target`: a mesh as any mesh,
/// everything else in its own format.
bool isWritableAs(const std::filesystem::path& source, const std::filesystem::path& target);

/// Throws InvalidInput where `target` has another ending than `source`.
void requireSameEnding(const std::filesystem::path& source, const std::filesystem::path& target);

/// Throws InvalidInput that names the file and the array.
[[noreturn]] void failForMissingArray(const std::filesystem::path& path, const Transport& transport,
                                      const std::string& why);

/// The remark on active normals that nobody asked to transport.
Remark keptNormalsRemark(const std::filesystem::path& path, const std::string& normals);

}  // namespace pbffd
