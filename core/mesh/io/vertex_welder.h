#pragma once

#include "core/base/types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pbffd::io {

/// Gives the same number to points whose coordinates are the same to the last bit (0 and -0 are the same),
/// counted from 0 in the order of their first occurrence.
class VertexWelder {
 public:
  VertexWelder();

  /// The number of a point whose coordinates are finite.
  Index add(const Vec3& point);

  /// All points, in the order of their numbers, as they first occurred.
  Points points() const;
  std::size_t size() const { return coordinates_.size() / 3; }

 private:
  std::size_t findSlot(const Vec3& point) const;
  void grow();

  std::vector<double> coordinates_;
  std::vector<Index> slots_;  ///< open addressing, a power of two, -1 where free
};

}  // namespace pbffd::io
