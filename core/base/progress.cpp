#include "core/base/progress.h"

#include "core/base/error.h"

#include <atomic>
#include <utility>

namespace pbffd {

struct Progress::State {
  Listener listener;
  std::atomic<bool> cancelled{false};
};

Progress::Progress(Listener listener) : state_(std::make_shared<State>()) {
  state_->listener = std::move(listener);
}

void Progress::report(std::string_view stage, double share) const {
  if (state_ && state_->listener) {
    state_->listener(stage, share);
  }
}

void Progress::cancel() const {
  if (state_) {
    state_->cancelled.store(true, std::memory_order_relaxed);
  }
}

bool Progress::isCancelled() const {
  return state_ && state_->cancelled.load(std::memory_order_relaxed);
}

void Progress::throwIfCancelled() const {
  if (isCancelled()) {
    throw Cancelled();
  }
}

}  // namespace pbffd
