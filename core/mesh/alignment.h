#pragma once

#include "core/base/affine.h"
#include "core/base/progress.h"
#include "core/mesh/rest_mesh.h"

namespace pbffd {

/// A map that keeps angles: x -> scale * rotation * x + translation.
struct Similarity {
  double scale = 1.0;  ///< > 0
  Mat3 rotation = Mat3::Identity();
  Vec3 translation = Vec3::Zero();

  AffineMap map() const { return makeMap(scale * rotation, translation); }
  AffineMap inverse() const {
    const Mat3 turn = rotation.transpose() / scale;
    return makeMap(turn, -(turn * translation));
  }
};

struct Alignment {
  Similarity toRest;          ///< takes the other mesh's points onto the rest mesh
  double meanDistance = 0.0;  ///< of its points from the rest mesh's nearest vertices, in the rest mesh's units
};

/// Fits place, size and turn of another mesh or point set of the same shape to the rest mesh, where nobody
/// knows which point is which: another level of detail, a scan. Starts from the centroids and principal axes
/// in all their proper orders and signs and from turns spread evenly over all of them, pairs nearest points
/// in both directions and fits by Umeyama's closed form, again and again, and keeps the best; pairs far apart
/// count less and less, so that a few strays do no harm. Where turns fit alike, that which there is already is
/// kept.
///
/// points: M x 3, at best a few ten thousand spread evenly; rows that are not finite are left out. The same
/// input gives the same bits. Throws InvalidInput where either side has no extent in two directions, Cancelled.
Alignment alignSimilar(const Points& points, const RestMesh& rest, const Progress& progress = {});

/// The least-squares similarity that takes `from` to `to` (Umeyama 1991), row by row, each pair weighted.
/// Both N x 3; the weights are positive.
Similarity fitSimilarity(const Points& from, const Points& to, const std::vector<double>& weights);

}  // namespace pbffd
