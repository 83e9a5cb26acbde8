#pragma once

#include <functional>
#include <memory>
#include <string_view>

namespace pbffd {

/// A copyable handle that long work reports to and asks whether to go on. Default-constructed it reports
/// to nobody and is never cancelled. All members may be called from any thread; `report` calls the
/// listener on the calling thread.
class Progress {
 public:
  /// stage: a few words in the user's language ("Placing points: cells"); share: 0 to 1 of that stage,
  /// negative when it cannot be known.
  using Listener = std::function<void(std::string_view stage, double share)>;

  Progress() = default;
  explicit Progress(Listener listener);

  void report(std::string_view stage, double share = -1.0) const;

  /// Asks the work that holds a copy of this handle to stop at its next check. Does nothing on a
  /// default-constructed handle.
  void cancel() const;
  bool isCancelled() const;

  /// Throws Cancelled once cancel() was called on any copy of this handle.
  void throwIfCancelled() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace pbffd
