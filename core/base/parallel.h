#pragma once

#include "core/base/types.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace pbffd {

/// Calls body(begin, end) on disjoint ranges that cover [0, count), on all cores. `grain` is the least
/// sensible length of a range. The body writes only slots of its own range, so that results do not depend
/// on the number of threads. An exception of a body reaches the caller.
void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Sorts on all cores. The result does not depend on the number of threads if no two values are equal.
template <class Value>
void parallelSort(std::vector<Value>& values) {
  constexpr std::size_t pieces = 8;
  constexpr std::size_t few = 8192;
  if (values.size() < few) {
    std::sort(values.begin(), values.end());
    return;
  }
  const auto border = [&](std::size_t piece) {
    return values.begin() + static_cast<std::ptrdiff_t>(values.size() * std::min(piece, pieces) / pieces);
  };
  parallelFor(pieces, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t piece = begin; piece < end; ++piece) {
      std::sort(border(piece), border(piece + 1));
    }
  });
  for (std::size_t width = 1; width < pieces; width *= 2) {
    parallelFor(pieces / (2 * width), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t pair = begin; pair < end; ++pair) {
        const std::size_t first = 2 * width * pair;
        std::inplace_merge(border(first), border(first + width), border(first + 2 * width));
      }
    });
  }
}

/// Runs `work` with its parallel loops on the calling thread alone: for what goes on beside another thread
/// that must not be slowed down.
void onThisThreadAlone(const std::function<void()>& work);

/// Runs `work` so that, waiting for its parallel loops, it takes up nothing from outside: for work under a
/// lock.
void isolated(const std::function<void()>& work);

/// The number of threads that parallelFor uses.
int threadCount();

/// While it lives, parallelFor uses at most `threads` threads (tests of independence, benchmarks).
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  void* control_;
};

}  // namespace pbffd
