#pragma once

#include "core/ffd/block_kernels.h"

// Included by files that are compiled for processors with more instructions than the rest of the program:
// nothing here may define a function that another file could share.

namespace pbffd {

/// The numbers of a Displacement: center and shift x y z; linear column after column.
struct DisplacementNumbers {
  const double* center;
  const double* linear;
  const double* shift;
};

/// One control point over the 16 points of a block.
struct SpaceTerm {
  const double* points;  ///< 16 x, 16 y, 16 z
  DisplacementNumbers displacement;
  const double* values;    ///< basis value x strength; 0 where it does not move the point
  const double* toWeight;  ///< makes weights of the values
};

/// What the gradients of a block are made of, summed over its control points; 16 numbers of each entry.
struct alignas(64) GradientSums {
  double linear[9 * 16];     ///< of w_j grad d_j + d_j (grad f_j)^T / sum_i f_i, row after row
  double slopes[3 * 16];     ///< of grad f_j
  double displaced[3 * 16];  ///< of w_j d_j
};

/// The inner loops of the deformation of space, over 16 points at a time. All variants give the same bits: none
/// contracts a multiplication and an addition.
struct SpaceKernels {
  /// sums += weight x displacement; 16 x, 16 y, 16 z.
  void (*addDisplacement)(const SpaceTerm& term, double* sums);
  /// The term of a control point that moved. `influence`: where and how its basis value varies.
  void (*addGradient)(const SpaceTerm& term, const InfluenceNumbers& influence, GradientSums& sums);
  /// The term of one at rest, whose basis value still counts.
  void (*addSlope)(const double* points, const InfluenceNumbers& influence, GradientSums& sums);
};

/// The fastest that both this processor and this build have.
const SpaceKernels& spaceKernels();

// One a source file, each compiled for its instructions; nullptr where the compiler does not have them.
const SpaceKernels* spacePlainKernels();
const SpaceKernels* spaceAvx2Kernels();
const SpaceKernels* spaceAvx512Kernels();

}  // namespace pbffd
