#include "core/base/parallel.h"
#include "core/ffd/deform/deformation.h"
#include "core/ffd/deform/displacement.h"

#include <algorithm>

namespace pbffd {
namespace {

constexpr std::size_t blockGrain = 64;

/// The gradient of strength x phi(u) in space, with u over `region`.
Vec3 valueGradient(const Basis& basis, double strength, const Region& region, const Vec3& point) {
  const Vec3 u = region.parameter(point);
  const double slope = 2.0 * strength * basisSlope(basis, region.squaredDistance(point));
  return slope * (region.toLocal.transpose() * u);
}

/// The sums over control points that the gradient of sum_j w_j d_j is made of, w_j = phi_j / sum_k phi_k:
/// sum_j w_j grad d_j + (sum_j d_j (x) grad phi_j - (sum_j w_j d_j) (x) grad sum_k phi_k) / sum_k phi_k.
struct GradientSums {
  Mat3 linear = Mat3::Zero();       ///< sum_j w_j grad d_j
  Mat3 outer = Mat3::Zero();        ///< sum_j d_j (x) grad phi_j
  Vec3 displaced = Vec3::Zero();    ///< sum_j w_j d_j
  Vec3 ofAllValues = Vec3::Zero();  ///< grad sum_k phi_k
  bool isReached = false;

  void addMoved(double weight, const Displacement& displacement, const Vec3& valueGradient, const Vec3& point) {
    const Vec3 d = displacement(point);
    linear += weight * displacement.linear;
    outer += d * valueGradient.transpose();
    displaced += weight * d;
    isReached = true;
  }

  Mat3 gradient(double toWeight) const {
    return Mat3::Identity() + linear + toWeight * (outer - displaced * ofAllValues.transpose());
  }
};

class GradientBlocks {
 public:
  GradientBlocks(const LevelValues& level, const PointBlocks& blocks, const LevelDisplacements& displacements)
      : level_(&level), values_(level, blocks), blocks_(&blocks), displacements_(&displacements) {}

  void evaluate(Index block, const BlockList& list) {
    block_ = block;
    list_ = list;
    values_.evaluate(block, list);
  }

  Mat3 at(Index k) const {
    const Vec3 point = blocks_->point(block_, k);
    const auto lane = static_cast<std::size_t>(k);
    const double toWeight = values_.toWeight()[lane];
    GradientSums sums;
    for (std::size_t e = 0; e < list_.points.size(); ++e) {
      if ((list_.members[e] >> k & 1) == 0) {
        continue;
      }
      const Index j = list_.points[e];
      const Vec3 ofValue = valueGradient(level_->basis(), level_->strength(j), level_->region(j), point);
      sums.ofAllValues += ofValue;
      if (displacements_->isMoved[static_cast<std::size_t>(j)] != 0) {
        sums.addMoved(values_.entries()[e][lane] * toWeight,
                      displacements_->points[static_cast<std::size_t>(j)], ofValue, point);
      }
    }
    addMaster(sums, point, values_.master()[lane] * toWeight);
    return sums.isReached && toWeight > 0.0 ? sums.gradient(toWeight) : Mat3::Identity();
  }

 private:
  void addMaster(GradientSums& sums, const Vec3& point, double weight) const {
    const Vec3 ofValue = level_->hasMasterRegion()
                             ? valueGradient(level_->basis(), 1.0, level_->masterRegion(), point)
                             : Vec3(Vec3::Zero());
    sums.ofAllValues += ofValue;
    if (displacements_->isMasterMoved) {
      sums.addMoved(weight, displacements_->master, ofValue, point);
    }
  }

  const LevelValues* level_;
  BlockValues values_;
  const PointBlocks* blocks_;
  const LevelDisplacements* displacements_;
  Index block_ = 0;
  BlockList list_;
};

}  // namespace

std::vector<Mat3> deformationGradients(const RestMesh& mesh, const ControlSet& set,
                                       const Parameterization& parameterization, const Progress& progress) {
  requireFitting(parameterization, mesh, set.finest());
  const LevelDisplacements displacements(set.master, set.finest());
  std::vector<Mat3> gradients(static_cast<std::size_t>(mesh.vertexCount()), Mat3::Identity());
  if (!displacements.isAnyMoved()) {
    return gradients;
  }
  progress.report("Turning normals");
  const std::vector<Index>& order = mesh.mortonOrder();
  const PointBlocks blocks(mesh.positions(), order);
  const LevelValues values(set.basis, set.master, set.finest());
  parallelFor(
      static_cast<std::size_t>(blocks.blockCount()), blockGrain, [&](std::size_t begin, std::size_t end) {
        progress.throwIfCancelled();
        GradientBlocks block(values, blocks, displacements);
        for (auto b = static_cast<Index>(begin); b < static_cast<Index>(end); ++b) {
          const BlockList list = parameterization.list(b);
          if (!displacements.touches(list)) {
            continue;
          }
          block.evaluate(b, list);
          const Index first = b * PointBlocks::blockSize;
          for (Index k = 0; k < std::min(PointBlocks::blockSize, mesh.vertexCount() - first); ++k) {
            gradients[static_cast<std::size_t>(order[static_cast<std::size_t>(first + k)])] = block.at(k);
          }
        }
      });
  return gradients;
}

}  // namespace pbffd
