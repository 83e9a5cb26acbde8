#pragma once

#include "app/apply_mpi/ranks.h"
#include "app/apply_mpi/stop_watch.h"
#include "app/dataset/apply.h"

#include <filesystem>

namespace pbffd::mpi {

struct SharedApply {
  std::filesystem::path project;
  std::filesystem::path source;
  std::filesystem::path target;
  ApplyOptions options;
};

/// Thrown on the ranks that have nothing to say when the work of another failed.
struct OtherRankFailed {};

/// What applyToFile() does to a partitioned data set, each rank with every count-th piece; the same bits as
/// on one process. The report of rank 0 is of all pieces. Where anything fails on any rank, every rank throws,
/// and nothing stays under the final names.
ApplyReport applyShared(const SharedApply& work, const Ranks& ranks, StopWatch& watch,
                        const Progress& progress);

}  // namespace pbffd::mpi
