#pragma once

#include "core/base/progress.h"

#include <csignal>
#include <filesystem>
#include <mutex>
#include <thread>

namespace pbffd::mpi {

/// While it lives, SIGINT and SIGTERM (which mpirun sends to all ranks when one of them dies) clean up and end
/// this process with status 1, even where it waits for another rank that will never answer.
/// Make it before MPI and before any thread: threads that come later leave the signals to this one.
class StopWatch {
 public:
  explicit StopWatch(const Progress& progress);
  ~StopWatch();
  StopWatch(const StopWatch&) = delete;
  StopWatch& operator=(const StopWatch&) = delete;

  /// The folder to remove when it comes to that; empty for none.
  void setFolder(const std::filesystem::path& folder);

 private:
  void watch();

  Progress progress_;
  sigset_t signals_;
  std::mutex mutex_;
  std::filesystem::path folder_;
  std::thread thread_;
};

}  // namespace pbffd::mpi
