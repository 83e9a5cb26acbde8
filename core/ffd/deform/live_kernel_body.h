#pragma once

#include "core/ffd/deform/live_kernel.h"

namespace pbffd {

/// The body that all kernels share. `Sixteen` holds a number for each vertex of a block; each kernel's file
/// defines its own in an unnamed namespace, so that no two files share an instance.
template <class Sixteen>
struct LiveBody {
  struct Three {
    Sixteen x, y, z;
  };

  /// linear v + shift.
  static Three displaced(const LiveMap& map, const Three& v) {
    const float* m = map.linear;
    const auto row = [&](const float* l, float shift) {
      return fused(Sixteen::all(l[2]), v.z,
                   fused(Sixteen::all(l[1]), v.y, fused(Sixteen::all(l[0]), v.x, Sixteen::all(shift))));
    };
    return {row(m, map.shift[0]), row(m + 3, map.shift[1]), row(m + 6, map.shift[2])};
  }

  /// Bit k: whether anything reaches the k-th vertex.
  static unsigned reachedBy(const LivePass& pass, std::int32_t block) {
    unsigned reached = pass.masterMembers[block];
    for (std::int32_t e = pass.blockStart[block]; e < pass.blockStart[block + 1]; ++e) {
      reached |= pass.members[e];
    }
    return reached;
  }

  static Three displacement(const LivePass& pass, std::int32_t block, const Three& rest) {
    Three sum{Sixteen::all(0.0F), Sixteen::all(0.0F), Sixteen::all(0.0F)};
    const std::int32_t end = pass.blockStart[block + 1];
    for (std::int32_t e = pass.blockStart[block]; e < end; ++e) {
      const LiveMap& map = pass.maps[pass.points[e]];
      if (map.kind == LiveMap::rest) {
        continue;
      }
      const Sixteen weight = Sixteen::load(pass.weights + 16 * static_cast<std::ptrdiff_t>(e));
      if (map.kind == LiveMap::translation) {
        sum = {fused(Sixteen::all(map.shift[0]), weight, sum.x),
               fused(Sixteen::all(map.shift[1]), weight, sum.y),
               fused(Sixteen::all(map.shift[2]), weight, sum.z)};
      } else {
        const Three d = displaced(map, rest);
        sum = {fused(d.x, weight, sum.x), fused(d.y, weight, sum.y), fused(d.z, weight, sum.z)};
      }
    }
    if (pass.master.kind != LiveMap::rest) {
      const unsigned reached = reachedBy(pass, block);
      const Three d = displaced(pass.master, rest);
      sum = {sum.x + kept(d.x, reached), sum.y + kept(d.y, reached), sum.z + kept(d.z, reached)};
    }
    return sum;
  }

  static void run(const LivePass& pass, const std::int32_t* blocks, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t block = blocks[i];
      const float* at = pass.rest + 48 * static_cast<std::ptrdiff_t>(block);
      const Three rest{Sixteen::load(at), Sixteen::load(at + 16), Sixteen::load(at + 32)};
      const Three d = displacement(pass, block, rest);
      float* out = block == pass.lastBlock ? pass.lastPositions
                                           : pass.positions + 48 * static_cast<std::ptrdiff_t>(block);
      store(rest.x + d.x, rest.y + d.y, rest.z + d.z, out);
    }
  }
};

}  // namespace pbffd
