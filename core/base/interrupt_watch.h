#pragma once

#include "core/base/progress.h"

#include <chrono>
#include <csignal>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace pbffd {

/// While it lives, SIGINT and SIGTERM cancel the work instead of ending the program at once. Work that has not
/// stopped within `patience` (it waits for its input, for another process) is then ended from here, with exit
/// status 1; files are only ever replaced whole, so that none is left half-written.
/// Make it before any thread is started: threads that come later leave the signals to this one.
class InterruptWatch {
 public:
  /// What is done, on a thread of its own, before the program is ended from here; returns what standard error
  /// is told.
  using LastWords = std::function<std::string()>;

  InterruptWatch(const Progress& progress, std::chrono::milliseconds patience, LastWords lastWords);
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  /// From now on these instead. Any thread.
  void setLastWords(LastWords lastWords);

 private:
  void watch();

  Progress progress_;
  std::chrono::milliseconds patience_;
  std::mutex mutex_;
  LastWords lastWords_;
  sigset_t signals_;
  sigset_t before_;
  std::thread thread_;
};

}  // namespace pbffd
