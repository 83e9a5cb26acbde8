#include "core/ffd/levels/binding.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/ffd/frame_checks.h"
#include "core/ffd/rest_centres.h"

#include <algorithm>

namespace pbffd {
namespace {

/// How far a pose may be from what its binding gives, in shares of the largest number in its frames.
constexpr double greatestLoss = 1e-9;

double largestNumber(const Frame& frame) {
  return std::max(frame.center.cwiseAbs().maxCoeff(), frame.axes.cwiseAbs().maxCoeff());
}

bool givesPose(const ControlPoint& point, const AffineMap& blend) {
  const Frame given = boundPose(point, blend);
  const Frame difference{given.center - point.pose.center, given.axes - point.pose.axes};
  return largestNumber(difference) <=
         greatestLoss * std::max(largestNumber(point.rest), largestNumber(point.pose));
}

bool areIdentity(const LevelMaps& maps) {
  return maps.master == identityMap() && std::all_of(maps.points.begin(), maps.points.end(),
                                                     [](const AffineMap& map) { return map == identityMap(); });
}

}  // namespace

PointWeights bindingWeights(const RestMesh& mesh, const ControlSet& set, Index level,
                            const Progress& progress) {
  return weightsAt(restCentres(set.levels[level]), mesh, set.basis, set.master, set.levels[level - 1],
                   progress);
}

Frame boundPose(const ControlPoint& point, const AffineMap& blend) {
  return moved(point.rest, composed(blend, point.binding.local));
}

Binding bindingTo(const ControlPoint& point, const AffineMap& blend, Index level) {
  ControlPoint bound = point;
  bound.binding.at = point.rest.center;
  const bool isUsable = isInvertible(blend.leftCols<3>());
  if (isUsable) {
    bound.binding.local = composed(inverted(blend), point.map());
  }
  if (!isUsable || !givesPose(bound, blend)) {
    throw InvalidInput(
        format("point {} cannot hang on level {}, which is flattened there; turn or stretch that level less",
               point.id, level + 1));
  }
  return bound.binding;
}

Index mendBindings(const RestMesh& mesh, ControlSet& set, const Progress& progress) {
  Index mended = 0;
  for (Index l = 1; l < static_cast<Index>(set.levels.size()); ++l) {
    Level& level = set.levels[l];
    const LevelMaps maps = mapsOf(set, set.levels[l - 1]);
    // The blend of maps that are all the identity needs no weights.
    const bool isMoved = !areIdentity(maps);
    const PointWeights weights = isMoved ? bindingWeights(mesh, set, l, progress) : PointWeights();
    for (Index i = 0; i < level.size(); ++i) {
      const AffineMap blend = isMoved ? blendedMap(weights, i, maps) : identityMap();
      if (!(level[i].binding.at == level[i].rest.center) || !givesPose(level[i], blend)) {
        ControlPoint point = level[i];
        point.binding = bindingTo(point, blend, l - 1);
        level.replace(i, std::move(point));
        ++mended;
      }
    }
  }
  return mended;
}

}  // namespace pbffd
