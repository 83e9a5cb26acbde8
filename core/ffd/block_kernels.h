#pragma once

#include <cstddef>
#include <cstdint>

// Included by files that are compiled for processors with more instructions than the rest of the program:
// nothing here may define a function that another file could share.

namespace pbffd {

/// The numbers of a Region: center x y z; toLocal column after column; inverseSquare.
struct RegionNumbers {
  const double* center;
  const double* toLocal;
  double inverseSquare;
};

/// A radial function: 0 smooth, 1 wendland, 2 gaussian (the order of Kernel).
struct RadialNumbers {
  int kernel;
  double sigma;
};

/// One control point.
struct PointNumbers {
  RegionNumbers region;
  RadialNumbers radial;
  double strength;
};

/// One control point over a block.
struct InfluenceNumbers : PointNumbers {
  unsigned members;  ///< bit k: whether it moves the k-th point
};

/// The inner loops of parameterization and of the exact deformation, over 16 points or 8 boxes at a time. All
/// variants give the same bits: none contracts a multiplication and an addition.
struct BlockKernels {
  /// |u|^2 of 16 points: 16 x, 16 y, 16 z.
  void (*squaredDistances)(const double* points, const RegionNumbers& region, double* uSquared);
  /// Bit k: whether |u| < 1 for the k-th point.
  unsigned (*inside)(const double* points, const RegionNumbers& region);
  /// Of 8 boxes (8 center x, y, z, 8 half x, y, z), bit k: whether the k-th may meet the region; bit 8 + k:
  /// whether it lies in the region, with all that inside() could be asked of its points.
  unsigned (*meets)(const double* boxes, const RegionNumbers& region);
  /// The squared distances of 16 points from a place, x y z, and bit k: whether the k-th is less than `limit`.
  unsigned (*nearPoints)(const double* points, const double* place, double limit, double* squared);
  /// The same of 8 boxes; a little less than the distance, for the rounding.
  unsigned (*nearBoxes)(const double* boxes, const double* place, double limit, double* squared);
  /// The basis values of 16 squared distances; 0 from the border on.
  void (*radial)(const RadialNumbers& radial, const double* uSquared, double* values);
  /// Of the control points in `list`, by their places in `level` and all with the same radial function, one after
  /// the other: strength x basis value at the members among 16 points (bit k of `members` for the k-th) and 0 at
  /// the others, 16 numbers each in `values`; adds them to the 16 `sums`.
  void (*memberValues)(const double* points, const PointNumbers* level, const std::int32_t* list,
                       const std::uint16_t* members, std::size_t count, double* values, double* sums);
  /// 1 over each of 16 sums; 0 where that is not finite.
  void (*inverses)(const double* sums, double* inverses);
  /// value x toWeight in single precision, of `count` times 16 values.
  void (*weights)(const double* values, std::size_t count, const double* toWeight, float* weights);
};

/// The fastest that both this processor and this build have.
const BlockKernels& blockKernels();

// One a source file, each compiled for its instructions; nullptr where the compiler does not have them.
const BlockKernels* blockPlainKernels();
const BlockKernels* blockAvx2Kernels();
const BlockKernels* blockAvx512Kernels();

}  // namespace pbffd
