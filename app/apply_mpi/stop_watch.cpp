#include "app/apply_mpi/stop_watch.h"

#include <pthread.h>
#include <unistd.h>

#include <string_view>
#include <system_error>

namespace pbffd::mpi {
namespace {

/// How the destructor wakes the thread.
constexpr int endOfWatch = SIGUSR1;

}  // namespace

StopWatch::StopWatch(const Progress& progress) : progress_(progress) {
  sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, endOfWatch}) {
    sigaddset(&signals_, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  thread_ = std::thread([this] { watch(); });
}

StopWatch::~StopWatch() {
  pthread_kill(thread_.native_handle(), endOfWatch);
  thread_.join();
}

void StopWatch::setFolder(const std::filesystem::path& folder) {
  const std::lock_guard lock(mutex_);
  folder_ = folder;
}

void StopWatch::watch() {
  int signal = 0;
  sigwait(&signals_, &signal);
  if (signal == endOfWatch) {
    return;
  }
  progress_.cancel();
  const std::lock_guard lock(mutex_);
  if (!folder_.empty()) {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  constexpr std::string_view message =
      "pbffd-apply-mpi: Stopped, by the user or because another rank ended; nothing was written.\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(1);
}

}  // namespace pbffd::mpi
