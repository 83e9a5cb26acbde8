#pragma once

#include "core/base/progress.h"
#include "core/ffd/deform/live_kernel.h"
#include "core/ffd/weights/parameterization.h"

#include <memory>
#include <vector>

namespace pbffd {

/// The deformed vertices in double precision, N x 3 in file order: v + sum_j w_j (M_j - I) v over the
/// members that moved, weights computed afresh in double (McDonnell & Qin, eqs. 4 to 7, in displacement
/// form). At rest the very bits of the mesh; the same bits on every processor and any number of threads.
Points deformExactly(const RestMesh& mesh, const ControlSet& set, const Parameterization& parameterization,
                     const Progress& progress = {});

/// The deformation gradient at each vertex, d v' / d v, analytic: what turns normals and frames and
/// stretches lengths. One a vertex in file order; identity at rest.
std::vector<Mat3> deformationGradients(const RestMesh& mesh, const ControlSet& set,
                                       const Parameterization& parameterization, const Progress& progress = {});

/// The deformed mesh kept up to date for the screen, in single precision relative to `origin`, in slots
/// (the mesh's Morton order). Positions are always re-evaluated from rest, so they cannot drift.
class LiveDeformation {
 public:
  /// At rest. Throws InvalidInput when the weights are of another number of vertices.
  LiveDeformation(std::shared_ptr<const RestMesh> mesh, std::shared_ptr<const Parameterization> weights);
  /// With these instructions instead of the best that the processor has; InvalidInput where it has not.
  LiveDeformation(std::shared_ptr<const RestMesh> mesh, std::shared_ptr<const Parameterization> weights,
                  Instructions instructions);
  ~LiveDeformation();
  LiveDeformation(LiveDeformation&&) noexcept;
  LiveDeformation& operator=(LiveDeformation&&) noexcept;

  /// Brings positions and normals to these maps, evaluating only the blocks that a changed map touches and
  /// the normals of the faces around them. Returns the number of vertices evaluated. Throws InvalidInput, and
  /// changes nothing, for another number of control points than the weights have.
  Index update(const LevelMaps& maps);

  /// update() in its two halves, for a caller that leaves normals for later: positions alone, and then the
  /// normals around all that moved since.
  Index updatePositions(const LevelMaps& maps);
  void updateNormals();

  /// Subtracted from every position before it became single precision: the centre of the rest bounds.
  const Vec3& origin() const;

  /// 3 a slot. The memory stays where it is as long as this object lives.
  const std::vector<float>& positions() const;
  const std::vector<float>& normals() const;

  /// 3 slots a triangle, in the order of the mesh's triangles().
  const std::vector<Index>& triangleSlots() const;

  /// The bytes of weights and lists: what deforming takes beside the arrays of a mesh on the screen (rest and
  /// deformed positions, normals, triangles).
  std::size_t bytesOfWeights() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pbffd
