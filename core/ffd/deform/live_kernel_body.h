#pragma once

#include "core/ffd/deform/live_kernel.h"

namespace pbffd {

/// The body that all kernels share. `Lanes` holds a number for each of as many vertices of a block as the
/// processor takes at a time; each kernel's file defines its own in an unnamed namespace, so that no two files
/// share an instance.
template <class Lanes>
struct LiveBody {
  static constexpr std::ptrdiff_t blockSize = 16;
  /// How many blocks before its turn a block is asked for. What processors foresee by themselves ends with the
  /// page, a block's weights are a quarter of one, and a drag jumps: without this a pass waits for memory half
  /// of its time.
  static constexpr std::size_t blocksAhead = 6;

  struct Three {
    Lanes x, y, z;
  };

  /// sum_j w_j d_j of a vertex in each lane, as a map. Twelve sums, so that all stay in registers.
  struct Blend {
    Three shift, ofX, ofY, ofZ;

    void addShift(const LiveMap& map, const Lanes& weight) {
      shift = added(map.shift, map.shift + 1, map.shift + 2, weight, shift);
    }
    void addLinear(const LiveMap& map, const Lanes& weight) {
      const float* const l = map.linear;
      ofX = added(l, l + 3, l + 6, weight, ofX);
      ofY = added(l + 1, l + 4, l + 7, weight, ofY);
      ofZ = added(l + 2, l + 5, l + 8, weight, ofZ);
    }
    Three operator()(const Three& v) const {
      return {fused(ofZ.x, v.z, fused(ofY.x, v.y, fused(ofX.x, v.x, shift.x))),
              fused(ofZ.y, v.z, fused(ofY.y, v.y, fused(ofX.y, v.x, shift.y))),
              fused(ofZ.z, v.z, fused(ofY.z, v.y, fused(ofX.z, v.x, shift.z)))};
    }

   private:
    static Three added(const float* x, const float* y, const float* z, const Lanes& weight, const Three& sum) {
      return {fused(Lanes::all(*x), weight, sum.x), fused(Lanes::all(*y), weight, sum.y),
              fused(Lanes::all(*z), weight, sum.z)};
    }
  };

  /// linear v + shift.
  static Three displaced(const LiveMap& map, const Three& v) {
    const auto row = [&](const float* l, float shift) {
      return fused(Lanes::all(l[2]), v.z,
                   fused(Lanes::all(l[1]), v.y, fused(Lanes::all(l[0]), v.x, Lanes::all(shift))));
    };
    return {row(map.linear, map.shift[0]), row(map.linear + 3, map.shift[1]),
            row(map.linear + 6, map.shift[2])};
  }

  /// Bit k: whether anything reaches the k-th vertex.
  static unsigned reachedBy(const LivePass& pass, std::int32_t block) {
    unsigned reached = pass.masterMembers[block];
    for (std::int32_t e = pass.blockStart[block]; e < pass.blockStart[block + 1]; ++e) {
      reached |= pass.members[e];
    }
    return reached;
  }

  /// The vertices of a block from the `first` on, as many as there are lanes.
  static void evaluate(const LivePass& pass, std::int32_t block, std::ptrdiff_t first, float* out) {
    const Three none{Lanes::all(0.0F), Lanes::all(0.0F), Lanes::all(0.0F)};
    Blend blend{none, none, none, none};
    const std::int32_t end = pass.blockStart[block + 1];
    for (std::int32_t e = pass.blockStart[block]; e < end; ++e) {
      const LiveMap& map = pass.maps[pass.points[e]];
      if (map.kind == LiveMap::rest) {
        continue;
      }
      const Lanes weight = Lanes::load(pass.weights + blockSize * e + first);
      blend.addShift(map, weight);
      if (map.kind == LiveMap::affine) {
        blend.addLinear(map, weight);
      }
    }
    const float* const at = pass.rest + 3 * blockSize * block + first;
    const Three rest{Lanes::load(at), Lanes::load(at + blockSize), Lanes::load(at + 2 * blockSize)};
    Three sum = blend(rest);
    if (pass.master.kind != LiveMap::rest) {
      const unsigned reached = reachedBy(pass, block) >> first;
      const Three d = displaced(pass.master, rest);
      sum = {sum.x + kept(d.x, reached), sum.y + kept(d.y, reached), sum.z + kept(d.z, reached)};
    }
    store(rest.x + sum.x, rest.y + sum.y, rest.z + sum.z, out + 3 * first);
  }

  static void run(const LivePass& pass, const std::int32_t* blocks, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      // In this function and not in one of its own: to the compiler, one that only prefetches does nothing.
      if (i + blocksAhead < count) {
        const std::int32_t ahead = blocks[i + blocksAhead];
        for (std::int32_t e = pass.blockStart[ahead]; e < pass.blockStart[ahead + 1]; ++e) {
          if (pass.maps[pass.points[e]].kind != LiveMap::rest) {
            __builtin_prefetch(pass.weights + blockSize * e);
          }
        }
        for (std::ptrdiff_t axis = 0; axis < 3; ++axis) {
          __builtin_prefetch(pass.rest + blockSize * (3 * std::ptrdiff_t{ahead} + axis));
        }
      }
      const std::int32_t block = blocks[i];
      float* const out = block == pass.lastBlock ? pass.lastPositions : pass.positions + 3 * blockSize * block;
      for (std::ptrdiff_t first = 0; first < blockSize; first += Lanes::count) {
        evaluate(pass, block, first, out);
      }
    }
  }
};

}  // namespace pbffd
