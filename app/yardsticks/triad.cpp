#include "app/yardsticks/triad.h"

#include "app/yardsticks/median.h"
#include "core/base/parallel.h"
#include "core/ffd/weights/large_array.h"

#include <algorithm>
#include <fstream>
#include <string>

#if defined(__linux__)
#include <unistd.h>
#endif

namespace pbffd {
namespace {

/// 0 where the system does not tell.
std::size_t lastLevelCache() {
  long bytes = 0;
#if defined(_SC_LEVEL3_CACHE_SIZE)
  bytes = std::max(sysconf(_SC_LEVEL3_CACHE_SIZE), sysconf(_SC_LEVEL2_CACHE_SIZE));
#endif
  return static_cast<std::size_t>(std::max(bytes, 0L));
}

/// What Linux says that programs may still take; 0 elsewhere.
std::size_t availableMemory() {
  std::ifstream lines("/proc/meminfo");
  for (std::string word; lines >> word;) {
    if (word == "MemAvailable:") {
      std::size_t kibibytes = 0;
      lines >> kibibytes;
      return kibibytes << 10U;
    }
  }
  return 0;
}

}  // namespace

Triad measureTriad(const Progress& progress) {
  constexpr std::size_t least = std::size_t{64} << 20U;
  Triad triad;
  triad.lastLevelCache = lastLevelCache();
  triad.bytesOfArray = std::max(std::min(4 * triad.lastLevelCache, availableMemory() / 4 / 3), least);
  const std::size_t count = triad.bytesOfArray / sizeof(float);
  LargeArray<float> a(count);
  LargeArray<float> b(count);
  LargeArray<float> c(count);
  const auto run = [&](const auto& body) {
    parallelFor(count, count / 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        body(i);
      }
    });
  };
  run([&](std::size_t i) {
    a[i] = 0.0F;
    b[i] = 1.0F;
    c[i] = 2.0F;
  });
  const double seconds =
      medianSeconds([&] { run([&](std::size_t i) { a[i] = b[i] + 3.0F * c[i]; }); }, progress);
  triad.bytesPerSecond = 3.0 * sizeof(float) * static_cast<double>(count) / seconds;
  return triad;
}

}  // namespace pbffd
