#pragma once

#include "core/base/progress.h"
#include "core/base/types.h"

#include <algorithm>

namespace pbffd {

/// Calls body(i) for each i in [0, count), in order, and asks now and then whether to go on: after a few
/// milliseconds of simple work. Throws Cancelled.
template <class Body>
void forEachIn(Index count, const Progress& progress, const Body& body) {
  constexpr Index piece = 1 << 16;
  for (Index begin = 0; begin < count;) {
    progress.throwIfCancelled();
    const Index end = begin + std::min(piece, count - begin);
    for (Index i = begin; i < end; ++i) {
      body(i);
    }
    begin = end;
  }
}

}  // namespace pbffd
