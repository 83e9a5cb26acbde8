#include "core/ffd/deform/slot_mesh.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>

namespace pbffd {
namespace {

constexpr Index blockSize = 16;
constexpr std::size_t grain = 64;

std::vector<Index> slotsOfTriangles(const RestMesh& mesh) {
  const std::vector<Index>& order = mesh.mortonOrder();
  std::vector<Index> slotOfVertex(order.size());
  for (std::size_t slot = 0; slot < order.size(); ++slot) {
    slotOfVertex[static_cast<std::size_t>(order[slot])] = static_cast<Index>(slot);
  }
  const std::span<const Index> vertices = mesh.triangles().vertices();
  std::vector<Index> slots(vertices.size());
  std::transform(vertices.begin(), vertices.end(), slots.begin(),
                 [&](Index vertex) { return slotOfVertex[static_cast<std::size_t>(vertex)]; });
  return slots;
}

/// Calls visit(block) once for each block that the triangle has a corner in.
template <class Visit>
void forEachBlock(const Index* corners, const Visit& visit) {
  const std::array<Index, 3> blocks{corners[0] / blockSize, corners[1] / blockSize, corners[2] / blockSize};
  visit(blocks[0]);
  if (blocks[1] != blocks[0]) {
    visit(blocks[1]);
  }
  if (blocks[2] != blocks[0] && blocks[2] != blocks[1]) {
    visit(blocks[2]);
  }
}

using Float3 = std::array<float, 3>;

Float3 difference(const float* a, const float* b, float scale) {
  return {(a[0] - b[0]) * scale, (a[1] - b[1]) * scale, (a[2] - b[2]) * scale};
}

Float3 cross(const Float3& a, const Float3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Zero stays zero.
Float3 normalized(const Float3& v) {
  const double x = v[0];
  const double y = v[1];
  const double z = v[2];
  const double length = std::sqrt(x * x + y * y + z * z);
  const double scale = length > 0.0 ? 1.0 / length : 0.0;
  return {static_cast<float>(x * scale), static_cast<float>(y * scale), static_cast<float>(z * scale)};
}

}  // namespace

SlotMesh::SlotMesh(const RestMesh& mesh)
    : origin_(mesh.bounds().center()),
      slotCount_(mesh.vertexCount()),
      edgeScale_(mesh.diagonal() > 0.0 ? static_cast<float>(1e3 / mesh.diagonal()) : 1.0F),
      triangleSlots_(slotsOfTriangles(mesh)) {
  fillRest(mesh);
  listTriangles();
}

void SlotMesh::fillRest(const RestMesh& mesh) {
  const std::size_t blocks = static_cast<std::size_t>((slotCount_ + blockSize - 1) / blockSize);
  rest_.resize(48 * blocks);
  parallelFor(blocks, grain, [&](std::size_t begin, std::size_t end) {
    std::fill(rest_.begin() + static_cast<std::ptrdiff_t>(48 * begin),
              rest_.begin() + static_cast<std::ptrdiff_t>(48 * end), 0.0F);
    for (std::size_t slot = begin * blockSize; slot < std::min<std::size_t>(slotCount_, end * blockSize);
         ++slot) {
      const Vec3 v = mesh.positions().row(mesh.mortonOrder()[slot]).transpose() - origin_;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        rest_[48 * (slot / blockSize) + blockSize * axis + slot % blockSize] =
            static_cast<float>(v[static_cast<Eigen::Index>(axis)]);
      }
    }
  });
}

void SlotMesh::listTriangles() {
  triangleStart_.assign(rest_.size() / 48 + 1, 0);
  const auto forEachTriangle = [&](const auto& visit) {
    for (std::size_t t = 0; 3 * t < triangleSlots_.size(); ++t) {
      forEachBlock(&triangleSlots_[3 * t], [&](Index block) { visit(static_cast<std::size_t>(block), t); });
    }
  };
  forEachTriangle([&](std::size_t block, std::size_t) { ++triangleStart_[block + 1]; });
  std::partial_sum(triangleStart_.begin(), triangleStart_.end(), triangleStart_.begin());
  triangles_.resize(static_cast<std::size_t>(triangleStart_.back()));
  std::vector<Index> next(triangleStart_.begin(), triangleStart_.end() - 1);
  forEachTriangle([&](std::size_t block, std::size_t t) {
    triangles_[static_cast<std::size_t>(next[block]++)] = static_cast<Index>(t);
  });
}

std::vector<Index> SlotMesh::blocksAround(const std::vector<Index>& blocks) const {
  std::vector<std::uint8_t> isAround(static_cast<std::size_t>(blockCount()), 0);
  parallelFor(blocks.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto block = static_cast<std::size_t>(blocks[i]);
      for (Index t = triangleStart_[block]; t < triangleStart_[block + 1]; ++t) {
        const std::size_t triangle = 3 * static_cast<std::size_t>(triangles_[static_cast<std::size_t>(t)]);
        forEachBlock(&triangleSlots_[triangle], [&](Index around) {
          // All write the same value.
          std::atomic_ref<std::uint8_t>(isAround[static_cast<std::size_t>(around)])
              .store(1, std::memory_order_relaxed);
        });
      }
    }
  });
  std::vector<Index> around;
  for (Index block = 0; block < blockCount(); ++block) {
    if (isAround[static_cast<std::size_t>(block)] != 0) {
      around.push_back(block);
    }
  }
  return around;
}

void SlotMesh::writeNormals(Index block, const std::vector<float>& positions,
                            std::vector<float>& normals) const {
  std::array<Float3, blockSize> sums{};
  const auto at = static_cast<std::size_t>(block);
  for (Index t = triangleStart_[at]; t < triangleStart_[at + 1]; ++t) {
    const Index* corner =
        &triangleSlots_[3 * static_cast<std::size_t>(triangles_[static_cast<std::size_t>(t)])];
    const float* origin = &positions[3 * static_cast<std::size_t>(corner[0])];
    const Float3 area =
        cross(difference(&positions[3 * static_cast<std::size_t>(corner[1])], origin, edgeScale_),
              difference(&positions[3 * static_cast<std::size_t>(corner[2])], origin, edgeScale_));
    for (int c = 0; c < 3; ++c) {
      if (corner[c] / blockSize == block) {
        Float3& sum = sums[static_cast<std::size_t>(corner[c] % blockSize)];
        sum = {sum[0] + area[0], sum[1] + area[1], sum[2] + area[2]};
      }
    }
  }
  const Index first = block * blockSize;
  for (Index k = 0; k < std::min(blockSize, slotCount_ - first); ++k) {
    const Float3 normal = normalized(sums[static_cast<std::size_t>(k)]);
    std::copy(normal.begin(), normal.end(), &normals[3 * static_cast<std::size_t>(first + k)]);
  }
}

std::size_t SlotMesh::bytesOfLists() const {
  return sizeof(Index) * (triangleStart_.size() + triangles_.size());
}

}  // namespace pbffd
