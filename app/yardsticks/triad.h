#pragma once

#include "core/base/progress.h"

#include <cstddef>

namespace pbffd {

/// STREAM's triad, a = b + s c, in single precision on all cores: what the memory gives.
struct Triad {
  double bytesPerSecond = 0.0;     ///< the median of some runs
  std::size_t bytesOfArray = 0;    ///< of each of the three
  std::size_t lastLevelCache = 0;  ///< in bytes; 0 where the system does not tell
};

/// Takes arrays of four times the last cache, as STREAM asks for, but no more than a quarter of the memory that
/// is left for all three, and at least 64 MiB each. Throws std::bad_alloc; Cancelled.
Triad measureTriad(const Progress& progress = {});

}  // namespace pbffd
