#include "app/cli/terminal_progress.h"

#include "core/base/text.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace pbffd::cli {
namespace {

using namespace std::chrono_literals;

/// Work that ends sooner shows nothing.
constexpr auto quietStart = 300ms;
/// More often than this the eye sees no difference.
constexpr auto interval = 50ms;

}  // namespace

TerminalProgress::TerminalProgress() : isTerminal_(::isatty(STDERR_FILENO) == 1) {}

void TerminalProgress::show(std::string_view stage, double share) {
  if (!isTerminal_) {
    return;
  }
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (now - started_ < quietStart || now - last_ < interval) {
    return;
  }
  last_ = now;
  isShown_ = true;
  const std::string line =
      share < 0.0 ? format("\r{} ...\033[K", stage) : format("\r{} {:.0f} %\033[K", stage, 100.0 * share);
  std::fputs(line.c_str(), stderr);
}

void TerminalProgress::clear() {
  const std::lock_guard lock(mutex_);
  if (isShown_) {
    std::fputs("\r\033[K", stderr);
    isShown_ = false;
  }
}

}  // namespace pbffd::cli
