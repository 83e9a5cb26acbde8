#pragma once

#include "core/base/progress.h"

#include <csignal>
#include <thread>

namespace pbffd::cli {

/// While it lives, SIGINT and SIGTERM cancel the work instead of ending the program at once. Work that has not
/// stopped within a moment (it waits for its input, say) is then ended from here, with exit status 1; files
/// are only ever replaced whole, so that none is left half-written.
/// Make it before any thread is started: threads that come later leave the signals to this one.
class InterruptWatch {
 public:
  explicit InterruptWatch(const Progress& progress);
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

 private:
  sigset_t signals_;
  sigset_t before_;
  std::thread thread_;
};

}  // namespace pbffd::cli
