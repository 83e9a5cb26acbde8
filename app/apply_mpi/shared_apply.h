#pragma once

#include "app/apply_mpi/ranks.h"
#include "app/dataset/apply.h"
#include "core/base/interrupt_watch.h"

#include <filesystem>
#include <string>

namespace pbffd::mpi {

struct SharedApply {
  std::filesystem::path project;
  std::filesystem::path source;
  std::filesystem::path target;
  ApplyOptions options;
};

/// Thrown on the ranks that have nothing to say when the work of another failed.
struct OtherRankFailed {};

/// What standard error is told when the program is ended before it begins to write.
std::string stoppedWords();

/// What applyToFile() does to a partitioned data set, each rank with every count-th piece; the same bits as
/// on one process. The report of rank 0 is of all pieces. Where anything fails on any rank, every rank throws,
/// and nothing stays under the final names. When `watch` ends this process, it removes what was staged and
/// names the rank that is gone, and its piece.
ApplyReport applyShared(const SharedApply& work, const Ranks& ranks, InterruptWatch& watch,
                        const Progress& progress);

}  // namespace pbffd::mpi
