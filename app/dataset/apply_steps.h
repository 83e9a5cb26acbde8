#pragma once

#include "app/dataset/apply.h"
#include "app/dataset/dataset.h"
#include "app/dataset/partition.h"
#include "core/mesh/alignment.h"

#include <functional>
#include <optional>

namespace pbffd {

// What applyToFile() is made of, for those who spread it over processes.

/// Whether it makes a difference that a data set has volume cells: some control point reaches `connected`.
bool dependsOnVolumeCells(const Project& project);

/// The remark that goes with volume cells.
std::string volumeCellsRemark(const std::filesystem::path& source);

/// Adds a remark where the work was done and no point moved.
void remarkIfStill(const Project& project, const std::filesystem::path& source, ApplyReport& report);

PlacedSpace placedSpace(const Project& project, bool hasVolumeCells, const std::optional<Similarity>& toRest,
                        const Progress& progress);

/// Throws InvalidInput that says that the file has no points.
[[noreturn]] void failForNoPoints(const std::filesystem::path& source);

/// Fits the points to the project's mesh; adds to the remarks how well.
Similarity alignedToRest(const Project& project, const Points& points, const Progress& progress,
                         ApplyReport& report);

/// A stride that leaves a few ten thousand of so many points, for the alignment.
std::int64_t strideFor(std::int64_t points);

/// Pieces `first`, `first + step`, ... of a partition: the share of one process.
struct PieceShare {
  std::size_t first = 0;
  std::size_t step = 1;
  std::function<void(std::size_t piece)> begins;  ///< told each piece before it is opened
};

/// Whether any piece of the share has volume cells.
bool haveVolumeCells(const Partition& partition, const PieceShare& share, const Progress& progress);

/// The number of points of the share.
std::int64_t countPoints(const Partition& partition, const PieceShare& share, const Progress& progress);

/// A few ten thousand points of all pieces. Throws InvalidInput where there are none.
Points samplePoints(const Partition& partition, const Progress& progress);

/// Deforms and stages the pieces of the share. Errors name the piece.
ApplyReport stagePieces(const Partition& partition, const PieceShare& share, StagedFiles& staged,
                        const Carrying& carrying);

}  // namespace pbffd
