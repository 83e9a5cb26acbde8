#include "core/ffd/refinement/refinement.h"

#include "core/ffd/placement/region_shape.h"
#include "core/ffd/refinement/fitted_poses.h"
#include "core/ffd/refinement/refined_places.h"
#include "core/ffd/rest_centres.h"
#include "core/mesh/nearest_face_vertex.h"

#include <algorithm>
#include <cmath>

namespace pbffd {
namespace {

/// No vertex moves farther, as a share of the diagonal.
constexpr double allowedChange = 0.005;
/// What a new point's strength is to that of the point it refines: the smaller ones rule where they are.
constexpr double strengthening = 2.0;
/// Where the nearest vertex lies at most, between centre and border.
constexpr double touchedAt = 0.8;

/// The usual regions of placement for the new places among all points, no larger and not much smaller than the
/// number of points tells.
std::vector<Frame> regionsFor(const std::vector<RefinedPlace>& places, const RefinementTask& task,
                              const PlacementOptions& options, const NearestFaceVertex& surface,
                              double diagonal) {
  Points centres(task.level.size() + static_cast<Index>(places.size()), 3);
  centres.topRows(task.level.size()) = restCentres(task.level);
  for (std::size_t i = 0; i < places.size(); ++i) {
    centres.row(task.level.size() + static_cast<Index>(i)) = places[i].center;
  }
  const std::vector<Frame> usual = regionsOf(centres, options.radiusFactor, options.regions, diagonal);
  std::vector<Frame> regions(usual.begin() + task.level.size(), usual.end());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double refined = sizeOf(task.level[places[i].refines].rest);
    const double size = sizeOf(regions[i]);
    const double wanted = std::clamp(size, refined / task.factor, refined * greatestShare(task.factor));
    regions[i].axes *= wanted / size;
    const double nearest = std::sqrt(Region(regions[i]).squaredDistance(surface.to(places[i].center)));
    regions[i].axes *= std::max(1.0, nearest / touchedAt);
  }
  return regions;
}

/// By the points in the order given, those of one point in the order they were found.
std::vector<RefinedPlace> chosenPlaces(const RefinementTask& task, RefinementPools pools, const RestMesh& mesh,
                                       unsigned seed, const Progress& progress) {
  const std::size_t wanted = task.places.size() * static_cast<std::size_t>(task.factor - 1);
  std::vector<RefinedPlace> chosen;
  for (const int placesForEach : {1, 4}) {
    spreadInside(pools, task, placesForEach, seed, progress);
    chosen = refinedPlaces(task, pools, mesh, progress);
    if (chosen.size() == wanted) {
      break;
    }
  }
  std::vector<Index> rank(static_cast<std::size_t>(task.level.size()), 0);
  for (std::size_t i = 0; i < task.places.size(); ++i) {
    rank[static_cast<std::size_t>(task.places[i])] = static_cast<Index>(i);
  }
  std::stable_sort(chosen.begin(), chosen.end(), [&](const RefinedPlace& a, const RefinedPlace& b) {
    return rank[static_cast<std::size_t>(a.refines)] < rank[static_cast<std::size_t>(b.refines)];
  });
  return chosen;
}

ControlPoint refining(const ControlPoint& refined, const Frame& region) {
  ControlPoint point;
  point.kind = refined.kind;
  point.reach = refined.reach;
  point.strength = strengthening * refined.strength;
  point.rest = region;
  point.pose = region;
  point.binding.at = region.center;
  return point;
}

}  // namespace

Refinement refinedPoints(const std::shared_ptr<const RestMesh>& mesh, const ControlSet& set,
                         const std::vector<Index>& places, const RefinementOptions& options,
                         const Progress& progress, const std::shared_ptr<const PlacementCache>& cache) {
  requirePlaceable(*mesh);
  const RefinementTask task{set.finest(), places, options.factor};
  Refinement result;
  result.cache = cache;
  const RefinementPools pools = refinementPools(mesh, task, options.placement, result.cache, progress);
  progress.report("Refining: places");
  const std::vector<RefinedPlace> chosen = chosenPlaces(task, pools, *mesh, options.placement.seed, progress);
  const double diagonal = pools.parts->diagonal();
  const std::vector<Frame> regions =
      regionsFor(chosen, task, options.placement, NearestFaceVertex(*mesh), diagonal);
  std::vector<ControlPoint> points;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    points.push_back(refining(task.level[chosen[i].refines], regions[i]));
  }
  FittedPoints fitted = fittedPoints(std::move(points), mesh, set, allowedChange * diagonal, progress);
  result.change = fitted.change;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    result.points.push_back({std::move(fitted.points[i]), chosen[i].refines});
  }
  return result;
}

}  // namespace pbffd
