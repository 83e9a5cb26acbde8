#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

namespace pbffd::cli {

/// Shows long work as one line on standard error that is rewritten in place, if that is a terminal; nothing
/// otherwise. May be called from any thread.
class TerminalProgress {
 public:
  TerminalProgress();

  /// stage and share as Progress reports them.
  void show(std::string_view stage, double share);

  /// Takes the line away, so that something else can be written.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  std::mutex mutex_;
  bool isTerminal_;
  bool isShown_ = false;
  Clock::time_point started_ = Clock::now();
  Clock::time_point last_;
};

}  // namespace pbffd::cli
