#include "core/ffd/placement/exterior_points.h"

namespace pbffd {

ExteriorPools exteriorPools(const SurfaceParts& parts, const SurfaceSamples& samples, double offset,
                            const Progress& progress) {
  const auto count = static_cast<std::size_t>(samples.size());
  const auto moved = [&](std::size_t i, double sign) -> Vec3 {
    const auto row = static_cast<Index>(i);
    return (samples.positions.row(row) + sign * offset * samples.normals.row(row)).transpose();
  };
  const std::vector<bool> insideAhead =
      parts.likelyInsideFlags(samples.positions + offset * samples.normals, progress);
  // Behind a closed part's samples is its inside, which is not asked.
  const std::vector<bool> insideBehind =
      parts.countOf(false) > 0 ? parts.likelyInsideFlags(samples.positions - offset * samples.normals, progress)
                               : std::vector<bool>(count, true);

  ExteriorPools pools;
  std::vector<bool> hasPoints(static_cast<std::size_t>(parts.count()), false);
  const auto take = [&](PointPool& pool, std::size_t i, double sign) {
    pool.append(moved(i, sign), samples.parts[i]);
    hasPoints[static_cast<std::size_t>(samples.parts[i])] = true;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const bool isClosed = parts.isClosed(samples.parts[i]);
    if (samples.normals.row(static_cast<Index>(i)).isZero()) {
      continue;
    }
    if (!insideAhead[i]) {
      take(isClosed ? pools.outside : pools.around, i, 1.0);
    }
    if (!isClosed && !insideBehind[i]) {
      take(pools.around, i, -1.0);
    }
  }
  // A part that lies wholly inside others keeps its points: an open one around itself, a closed one inside.
  for (std::size_t i = 0; i < count; ++i) {
    if (!hasPoints[static_cast<std::size_t>(samples.parts[i])]) {
      if (parts.isClosed(samples.parts[i])) {
        pools.enclosed.append(moved(i, 1.0), samples.parts[i]);
      } else {
        pools.around.append(moved(i, 1.0), samples.parts[i]);
        pools.around.append(moved(i, -1.0), samples.parts[i]);
      }
    }
  }
  pools.outside.dropDoubles();
  pools.around.dropDoubles();
  pools.enclosed.dropDoubles();
  return pools;
}

}  // namespace pbffd
