#include "core/project/mirror.h"

#include "core/ffd/rest_centres.h"
#include "core/mesh/nearest.h"

namespace pbffd {
namespace {

/// Partners lie within this share of the region.
constexpr double nearness = 0.1;

bool isNear(const Frame& rest, const Vec3& place) {
  return Region(rest).squaredDistance(place) <= nearness * nearness;
}

}  // namespace

AffineMap reflection(Axis axis, const Vec3& through) {
  const int k = static_cast<int>(axis);
  AffineMap map = identityMap();
  map(k, k) = -1.0;
  map(k, 3) = 2.0 * through[k];
  return map;
}

std::vector<Index> mirrorPartners(const Level& level, Axis axis, const Vec3& through) {
  const AffineMap mirror = reflection(axis, through);
  const NearestPoints tree(restCentres(level));
  std::vector<Index> nearest(level.size());
  for (Index i = 0; i < level.size(); ++i) {
    nearest[i] = tree.nearest(applyMap(mirror, level[i].rest.center)).index;
  }
  std::vector<Index> partners(level.size(), -1);
  for (Index i = 0; i < level.size(); ++i) {
    const Index other = nearest[i];
    if (nearest[other] == i && isNear(level[other].rest, applyMap(mirror, level[i].rest.center)) &&
        isNear(level[i].rest, applyMap(mirror, level[other].rest.center))) {
      partners[i] = other;
    }
  }
  return partners;
}

Vec3 mirrorCenter(const Project& project, const Spread& spread) {
  return spread.hasPlane ? spread.plane : project.mesh->bounds().center();
}

}  // namespace pbffd
