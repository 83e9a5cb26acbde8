#pragma once

#include "core/ffd/placement/point_pool.h"

namespace pbffd {

/// What of a pool inside the closed parts is a choice for `target` points: places that are far enough apart to
/// be told from each other, at least one of each part. Where fewer than `target` of them stand well apart (the
/// medial axis of a sphere is its centre alone), points spread over the inside beside them, so that as many do
/// as well as the volume allows; and points in balls inside the mesh that hold far fewer places than their share
/// of the volume, whatever there is elsewhere. At least `target` places come back wherever the closed parts have
/// any inside. Throws Cancelled.
PointPool withInteriorSamples(const PointPool& pool, Index target, const SurfaceParts& parts, unsigned seed,
                              const Progress& progress);

}  // namespace pbffd
