#include "app/cli/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <ctime>
#include <string_view>

namespace pbffd::cli {
namespace {

/// How the destructor wakes the thread.
constexpr int endOfWatch = SIGUSR1;

/// How long cancelled work may take to stop by itself.
constexpr timespec patience{0, 800'000'000};

void watch(const sigset_t& signals, const Progress& progress) {
  int signal = 0;
  sigwait(&signals, &signal);
  if (signal == endOfWatch) {
    return;
  }
  progress.cancel();
  if (sigtimedwait(&signals, nullptr, &patience) == endOfWatch) {
    return;
  }
  constexpr std::string_view message = "pbffd: Cancelled; nothing was written.\n";
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(1);
}

}  // namespace

InterruptWatch::InterruptWatch(const Progress& progress) {
  sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, endOfWatch}) {
    sigaddset(&signals_, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  thread_ = std::thread([this, progress] { watch(signals_, progress); });
}

InterruptWatch::~InterruptWatch() {
  pthread_kill(thread_.native_handle(), endOfWatch);
  thread_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace pbffd::cli
