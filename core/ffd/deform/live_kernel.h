#pragma once

#include "core/ffd/instructions.h"

#include <cstddef>
#include <cstdint>

// Included by files that are compiled for processors with more instructions than the rest of the program:
// nothing here may define a function that another file could share.

namespace pbffd {

/// What a control point does to space relative to rest, in single precision about the origin of the live
/// positions: d(v) = linear v + shift.
struct alignas(64) LiveMap {
  enum Kind : std::int32_t { rest, translation, affine };

  float shift[3];
  float linear[9];  ///< row after row
  Kind kind;
};

/// The arrays of a pass over blocks of 16 vertices. Nothing is owned.
struct LivePass {
  const float* rest;  ///< a block's 16 x, 16 y, 16 z
  const std::int32_t* blockStart;
  const std::int32_t* points;
  const std::uint16_t* members;
  const float* weights;
  const std::uint16_t* masterMembers;
  const LiveMap* maps;  ///< one a control point, the master's taken off
  LiveMap master;
  float* positions;        ///< x y z of each vertex
  float* lastPositions;    ///< those of the last block, which may not be full
  std::int32_t lastBlock;  ///< its number, or -1
};

/// Evaluates the blocks named, each from rest: v + sum_j w_j d_j(v), where the master's share is what the
/// others leave of 1: master(v) + sum_j w_j (d_j - master)(v).
using LiveKernel = void (*)(const LivePass& pass, const std::int32_t* blocks, std::size_t count);

/// The most that both this processor and this build have.
Instructions bestInstructions();

/// The kernel for these instructions; nullptr where the processor or the build does not have them.
LiveKernel liveKernel(Instructions instructions);

}  // namespace pbffd
