#pragma once

#include "app/apply_mpi/ranks.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace pbffd::mpi {

/// Which rank works on which piece, noted in the folder of the staged files, so that the others can tell when
/// one is killed.
class WorkNotes {
 public:
  /// All ranks make it together.
  WorkNotes(const Ranks& ranks, std::filesystem::path folder);

  void workingOn(std::size_t piece) const;

  struct Lost {
    int rank;
    std::optional<std::size_t> piece;  ///< none where it had not begun
  };
  /// The lowest rank that ran on this machine and is gone; nothing where all are there, or where another rank
  /// has removed the folder already.
  std::optional<Lost> lost() const;

 private:
  std::filesystem::path noteOf(int rank) const;

  std::filesystem::path folder_;
  int rank_;
  std::vector<long long> processes_;  ///< by rank; 0 on other machines
};

}  // namespace pbffd::mpi
