#include "core/ffd/deform/nearest_vertices.h"

#include <bit>
#include <limits>

namespace pbffd {
namespace {

struct Candidate {
  double squared;
  Index vertex;

  void meet(const Candidate& other) {
    if (other.squared < squared || (other.squared == squared && other.vertex < vertex)) {
      *this = other;
    }
  }
};

/// In the order of operations of the block kernels.
double squaredNorm(const Vec3& v) {
  return v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
}

}  // namespace

NearestVertices::NearestVertices(const RestMesh& mesh)
    : mesh_(mesh), blocks_(mesh.positions(), mesh.mortonOrder()) {}

Index NearestVertices::nearest(const Vec3& place, Index guess) const {
  const std::vector<Index>& order = mesh_.mortonOrder();
  Candidate best{squaredNorm(mesh_.positions().row(guess).transpose() - place), guess};
  // A little more than the least distance, for ties and for the rounding of the boxes.
  const auto limit = [&] { return (1.0 + 1e-12) * best.squared + std::numeric_limits<double>::min(); };
  const BlockKernels& kernels = blockKernels();
  blocks_.forEachWithin(place, limit, [&](Index block) {
    Lanes squared;
    unsigned left = kernels.nearPoints(blocks_.numbers(block), place.data(), limit(), squared.data());
    for (; left != 0; left &= left - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(left));
      best.meet({squared[k], order[static_cast<std::size_t>(block) * PointBlocks::blockSize + k]});
    }
  });
  return best.vertex;
}

}  // namespace pbffd
