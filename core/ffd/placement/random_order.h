#pragma once

#include <cstdint>
#include <numeric>

namespace pbffd {

/// Numbers that look random and are the same on every machine (SplitMix64, Steele et al. 2014).
inline std::uint64_t scrambled(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
  value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
  return value ^ (value >> 31);
}

/// In [0, 1), a function of seed and index alone.
inline double randomShare(std::uint64_t seed, std::uint64_t index) {
  return static_cast<double>(scrambled(scrambled(seed) ^ index) >> 11) * 0x1p-53;
}

/// Visits 0 to count - 1 each once, in an order far from the given one: i -> (step i + first) mod count.
class RandomOrder {
 public:
  RandomOrder(std::uint64_t count, std::uint64_t seed) : count_(count) {
    if (count > 1) {
      first_ = scrambled(seed) % count;
      // About the golden ratio, so that what lies side by side is visited far apart.
      step_ = static_cast<std::uint64_t>(static_cast<double>(count) * (0.6 + 0.036 * randomShare(seed, 1)));
      while (step_ == 0 || std::gcd(step_, count) != 1) {
        ++step_;
      }
    }
  }
  std::uint64_t operator[](std::uint64_t i) const { return (step_ * i + first_) % count_; }

 private:
  std::uint64_t count_;
  std::uint64_t step_ = 1;
  std::uint64_t first_ = 0;
};

}  // namespace pbffd
