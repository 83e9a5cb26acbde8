#include "core/ffd/placement/exterior_points.h"

#include "core/base/parallel.h"

#include <cstdint>

namespace pbffd {
namespace {

/// The way out starts at this share of the offset, clear of the faces around the sample.
constexpr double startOfWay = 1e-3;

}  // namespace

ExteriorPools exteriorPools(const SurfaceParts& parts, const SurfaceSamples& samples, double offset,
                            const Progress& progress) {
  const auto count = static_cast<std::size_t>(samples.size());
  const auto moved = [&](std::size_t i, double sign) -> Vec3 {
    const auto row = static_cast<Index>(i);
    return (samples.positions.row(row) + sign * offset * samples.normals.row(row)).transpose();
  };
  const bool isSimple = parts.count() == 1;
  std::vector<std::uint8_t> insideAhead(count);
  std::vector<std::uint8_t> insideBehind(count);
  parallelFor(count, 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress.isCancelled(); ++i) {
      // Mostly nothing lies on the way out, which is found faster than a winding number.
      const bool isClear =
          isSimple && parts.isClosed(0) && !parts.isBetween(moved(i, startOfWay), moved(i, 1.0));
      insideAhead[i] = !isClear && parts.isInside(moved(i, 1.0));
      insideBehind[i] = !parts.isClosed(samples.parts[i]) && parts.isInside(moved(i, -1.0));
    }
  });
  progress.throwIfCancelled();

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
