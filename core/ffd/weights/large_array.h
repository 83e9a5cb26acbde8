#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace pbffd {

/// Memory on a cache line's border, in large pages where the system offers them; what was in it before may
/// still be there. Up to 192 MiB of what is freed is kept for the next. Throws std::bad_alloc.
void* allocateLarge(std::size_t bytes);
void freeLarge(void* memory);

/// For arrays of numbers as long as a mesh: aligned for vector instructions, and left as they are by
/// resize(), so that the threads that fill them are the first to touch their pages.
template <class Number>
class LargeAllocator {
 public:
  using value_type = Number;

  LargeAllocator() = default;
  template <class Other>
  explicit LargeAllocator(const LargeAllocator<Other>&) {}

  Number* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(Number)) {
      throw std::bad_array_new_length();
    }
    return static_cast<Number*>(allocateLarge(count * sizeof(Number)));
  }
  void deallocate(Number* memory, std::size_t) { freeLarge(memory); }

  template <class Made>
  void construct(Made* at) {
    ::new (static_cast<void*>(at)) Made;
  }
  template <class Made, class... From>
  void construct(Made* at, From&&... from) {
    ::new (static_cast<void*>(at)) Made(std::forward<From>(from)...);
  }

  bool operator==(const LargeAllocator&) const = default;
};

/// A vector whose resize() leaves new numbers unset: whoever resizes it writes them all.
template <class Number>
using LargeArray = std::vector<Number, LargeAllocator<Number>>;

}  // namespace pbffd
