#pragma once

#include "core/base/progress.h"
#include "core/ffd/control_set.h"
#include "core/mesh/rest_mesh.h"

#include <memory>
#include <vector>

namespace pbffd {

/// Which points of its region a control point moves: what it says itself (ControlPoint::reach), or all of
/// them, as data with volume cells needs, which would tear between two limbs (contract, section 4).
enum class ReachRule { asStored, all };

/// Where a deformation takes places, and how it turns and stretches what is there.
struct SpaceImage {
  Points positions;             ///< N x 3, row i = place i
  std::vector<Mat3> gradients;  ///< d position / d place, one a place; identity where nothing moves
};

/// The deformation space itself: carries any points, not only the vertices that it was made for (McDonnell &
/// Qin, eqs. 3 to 7, as decided in the contract, section 4). Made ready once from the mesh, the finest level
/// and the master; then a function of the place alone: the same bits in any order, in any portion, on any
/// number of threads. At a rest vertex the very bits of deformExactly(). Every member may be called from any
/// thread.
class SpaceDeformation {
 public:
  /// Throws Cancelled.
  SpaceDeformation(std::shared_ptr<const RestMesh> mesh, const ControlSet& set,
                   ReachRule rule = ReachRule::asStored, const Progress& progress = {});
  ~SpaceDeformation();
  SpaceDeformation(SpaceDeformation&&) noexcept;
  SpaceDeformation& operator=(SpaceDeformation&&) noexcept;

  /// Whether any control point or the master is away from rest; else every place stays.
  bool movesAnything() const;

  /// Where the places go; N x 3. The work is about proportional to the number of places times the regions
  /// around each. A place without finite coordinates stays. Throws Cancelled.
  Points positions(const Eigen::Ref<const Points>& places, const Progress& progress = {}) const;

  /// The same with the deformation gradients, analytic, those of the weights included. Throws Cancelled.
  SpaceImage image(const Eigen::Ref<const Points>& places, const Progress& progress = {}) const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

}  // namespace pbffd
