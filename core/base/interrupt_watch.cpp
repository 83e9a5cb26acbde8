#include "core/base/interrupt_watch.h"

#include <pthread.h>
#include <unistd.h>

#include <ctime>
#include <utility>

namespace pbffd {
namespace {

/// How the destructor wakes the thread.
constexpr int endOfWatch = SIGUSR1;

}  // namespace

InterruptWatch::InterruptWatch(const Progress& progress, std::chrono::milliseconds patience,
                               LastWords lastWords)
    : progress_(progress), patience_(patience), lastWords_(std::move(lastWords)) {
  sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, endOfWatch}) {
    sigaddset(&signals_, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  thread_ = std::thread([this] { watch(); });
}

InterruptWatch::~InterruptWatch() {
  pthread_kill(thread_.native_handle(), endOfWatch);
  thread_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void InterruptWatch::setLastWords(LastWords lastWords) {
  const std::lock_guard lock(mutex_);
  lastWords_ = std::move(lastWords);
}

void InterruptWatch::watch() {
  int signal = 0;
  sigwait(&signals_, &signal);
  if (signal == endOfWatch) {
    return;
  }
  progress_.cancel();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(patience_);
  const timespec patience{seconds.count(), std::chrono::nanoseconds(patience_ - seconds).count()};
  if (sigtimedwait(&signals_, nullptr, &patience) == endOfWatch) {
    return;
  }
  const std::lock_guard lock(mutex_);
  const std::string words = lastWords_();
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, words.data(), words.size());
  ::_exit(1);
}

}  // namespace pbffd
