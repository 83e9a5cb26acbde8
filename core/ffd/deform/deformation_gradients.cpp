#include "core/ffd/deform/deformation.h"
#include "core/ffd/deform/touched_vertices.h"

namespace pbffd {
namespace {

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

class ExactGradients : public BlockEvaluator {
 public:
  using BlockEvaluator::BlockEvaluator;

  Mat3 at(Index k) const {
    const Vec3 rest = point(k);
    const auto lane = static_cast<std::size_t>(k);
    const double toWeight = values_.toWeight()[lane];
    GradientSums sums;
    for (std::size_t e = 0; e < list_.points.size(); ++e) {
      if (!isMember(e, k)) {
        continue;
      }
      const Index j = list_.points[e];
      const Vec3 ofValue = valueGradient(level_->basis(), level_->numbers()[j].strength, level_->region(j), rest);
      sums.ofAllValues += ofValue;
      if (displacements_->isMoved[static_cast<std::size_t>(j)] != 0) {
        sums.addMoved(values_.entries()[e][lane] * toWeight,
                      displacements_->points[static_cast<std::size_t>(j)], ofValue, rest);
      }
    }
    addMaster(sums, rest, values_.master()[lane] * toWeight);
    return sums.isReached && toWeight > 0.0 ? sums.gradient(toWeight) : Mat3::Identity();
  }

 private:
  void addMaster(GradientSums& sums, const Vec3& rest, double weight) const {
    const Vec3 ofValue = level_->hasMasterRegion()
                             ? valueGradient(level_->basis(), 1.0, level_->masterRegion(), rest)
                             : Vec3(Vec3::Zero());
    sums.ofAllValues += ofValue;
    if (displacements_->isMasterMoved) {
      sums.addMoved(weight, displacements_->master, ofValue, rest);
    }
  }
};

}  // namespace

std::vector<Mat3> deformationGradients(const RestMesh& mesh, const ControlSet& set,
                                       const Parameterization& parameterization, const Progress& progress) {
  const TouchedVertices touched(mesh, set, parameterization);
  std::vector<Mat3> gradients(static_cast<std::size_t>(mesh.vertexCount()), Mat3::Identity());
  if (touched.areAny()) {
    progress.report("Turning normals");
    touched.forEach<ExactGradients>(progress, [&](Index vertex, const Mat3& gradient) {
      gradients[static_cast<std::size_t>(vertex)] = gradient;
    });
  }
  return gradients;
}

}  // namespace pbffd
