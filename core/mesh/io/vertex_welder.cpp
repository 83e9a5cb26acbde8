#include "core/mesh/io/vertex_welder.h"

#include <bit>

namespace pbffd::io {
namespace {

constexpr std::size_t firstSlots = 1024;

/// Mixes the bits of the coordinates (by the constants of the splitmix64 generator); adding 0 makes -0 a 0.
std::uint64_t hashOf(const Vec3& point) {
  std::uint64_t hash = 0;
  for (int axis = 0; axis < 3; ++axis) {
    hash += 0x9E3779B97F4A7C15U + std::bit_cast<std::uint64_t>(point[axis] + 0.0);
    hash = (hash ^ (hash >> 30)) * 0xBF58476D1CE4E5B9U;
    hash = (hash ^ (hash >> 27)) * 0x94D049BB133111EBU;
    hash ^= hash >> 31;
  }
  return hash;
}

}  // namespace

VertexWelder::VertexWelder() : slots_(firstSlots, -1) {}

/// The slot that holds the point, or the free one where it belongs.
std::size_t VertexWelder::findSlot(const Vec3& point) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hashOf(point) & mask;
  while (slots_[slot] >= 0) {
    const double* known = coordinates_.data() + 3 * static_cast<std::size_t>(slots_[slot]);
    if (known[0] == point[0] && known[1] == point[1] && known[2] == point[2]) {
      break;
    }
    slot = (slot + 1) & mask;
  }
  return slot;
}

Index VertexWelder::add(const Vec3& point) {
  const std::size_t slot = findSlot(point);
  if (slots_[slot] >= 0) {
    return slots_[slot];
  }
  const auto number = static_cast<Index>(size());
  slots_[slot] = number;
  coordinates_.insert(coordinates_.end(), {point[0], point[1], point[2]});
  if (2 * size() > slots_.size()) {
    grow();
  }
  return number;
}

void VertexWelder::grow() {
  slots_.assign(2 * slots_.size(), -1);
  for (std::size_t i = 0; i < size(); ++i) {
    const double* at = coordinates_.data() + 3 * i;
    slots_[findSlot({at[0], at[1], at[2]})] = static_cast<Index>(i);
  }
}

Points VertexWelder::points() const {
  return Eigen::Map<const Points>(coordinates_.data(), static_cast<Eigen::Index>(size()), 3);
}

}  // namespace pbffd::io
