#pragma once

#include "core/base/types.h"

#include <cstddef>
#include <functional>

namespace pbffd {

/// Calls body(begin, end) on disjoint ranges that cover [0, count), on all cores. `grain` is the least
/// sensible length of a range. The body writes only slots of its own range, so that results do not depend
/// on the number of threads. An exception of a body reaches the caller.
void parallelFor(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t begin, std::size_t end)>& body);

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
