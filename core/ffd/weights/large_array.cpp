#include "core/ffd/weights/large_array.h"

#include <cstdlib>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace pbffd {
namespace {

constexpr std::size_t cacheLine = 64;
constexpr std::size_t largePage = std::size_t{1} << 21;

std::size_t alignmentFor(std::size_t bytes) {
  return bytes >= 2 * largePage ? largePage : cacheLine;
}

}  // namespace

void* allocateLarge(std::size_t bytes) {
  const std::size_t alignment = alignmentFor(bytes);
  const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
#if defined(__linux__)
  if (alignment == largePage) {
    // A wish: where the system has no large pages, small ones serve as well.
    static_cast<void>(madvise(memory, rounded, MADV_HUGEPAGE));
  }
#endif
  return memory;
}

void freeLarge(void* memory) {
  std::free(memory);
}

}  // namespace pbffd
