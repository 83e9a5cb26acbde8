#include "core/ffd/placement/placement.h"

#include "core/base/error.h"
#include "core/base/figures.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/ffd/placement/coverage.h"
#include "core/ffd/placement/interior_samples.h"
#include "core/ffd/placement/placement_cache.h"
#include "core/ffd/placement/region_shape.h"
#include "core/ffd/placement/shares.h"
#include "core/mesh/face_vertices.h"
#include "core/mesh/spread.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace pbffd {

namespace {

constexpr auto notPlaced = "Control points cannot be placed: ";

void requireFinite(const RestMesh& mesh) {
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (!mesh.positions().row(v).allFinite()) {
      throw InvalidInput(format(
          "{}vertex {} has a coordinate that is not a finite number. Correct it in the mesh.", notPlaced, v));
    }
  }
}

/// Areas are squared on the way, and have to stay within double precision.
void requireUsableSize(const Points& surface) {
  constexpr double least = 1e-60;
  constexpr double greatest = 1e60;
  const Bounds bounds = boundsOf(surface);
  const double diagonal = (bounds.high - bounds.low).stableNorm();
  const double size = surface.cwiseAbs().maxCoeff();
  if (size > greatest || (diagonal > 0.0 && diagonal < least)) {
    throw InvalidInput(
        format("{}the mesh has a diagonal of {} and coordinates up to {}, where {} to {} can be worked with. "
               "Scale it to another unit.",
               notPlaced, diagonal, size, least, greatest));
  }
}

bool haveCorners(const Polygons& faces) {
  for (Index f = 0; f < faces.size(); ++f) {
    if (faces[f].size() >= 3) {
      return true;
    }
  }
  return false;
}

bool hasArea(const RestMesh& mesh) {
  const std::span<const Index> corners = mesh.triangles().vertices();
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    const auto at = [&](std::size_t k) -> Vec3 { return mesh.positions().row(corners[t + k]); };
    if (!(at(1) - at(0)).cross(at(2) - at(0)).isZero(0.0)) {
      return true;
    }
  }
  return false;
}

}  // namespace

void requirePlaceable(const RestMesh& mesh) {
  if (!haveCorners(mesh.mesh().faces)) {
    throw InvalidInput(
        format("{}the mesh has {} vertices, but no faces that span a surface. Take a mesh with faces; if it "
               "should have some, export it again.",
               notPlaced, counted(mesh.vertexCount())));
  }
  requireFinite(mesh);
  // Nothing takes more memory while it is made: it comes before the triangles, which are kept.
  static_cast<void>(mesh.topology());
  const FacePositions ofFaces(mesh.mesh());
  const Points& surface = ofFaces.points();
  requireUsableSize(surface);
  const Vec3 spread = spreadOf(surface);
  const char* const where = spread[2] == 0.0                        ? "in one point"
                            : spread[1] <= roundingShareOf(surface) ? "on one line"
                                                                    : nullptr;
  if (where != nullptr) {
    throw InvalidInput(format("{}all {} vertices of its faces lie {}. Check how the mesh was exported.",
                              notPlaced, counted(surface.rows()), where));
  }
  if (!hasArea(mesh)) {
    throw InvalidInput(format("{}none of the {} faces has an area. Check how the mesh was exported.", notPlaced,
                              counted(mesh.mesh().faces.size())));
  }
}

namespace {

/// The Voronoi vertices, and what stands in for them where a part has none.
PointPool interiorPool(const PlacementCache& cache, Index wanted, const PlacementOptions& options,
                       const Progress& progress) {
  PointPool pool = withInteriorSamples(*cache.interior, wanted, *cache.parts, options.seed, progress);
  std::vector<bool> hasPoints(static_cast<std::size_t>(cache.parts->count()), false);
  for (const Index part : pool.parts) {
    hasPoints[static_cast<std::size_t>(part)] = true;
  }
  const PointPool& enclosed = cache.exterior->enclosed;
  for (Index i = 0; i < enclosed.size(); ++i) {
    if (!hasPoints[static_cast<std::size_t>(enclosed.parts[i])]) {
      pool.append(enclosed.points.row(i), enclosed.parts[i]);
    }
  }
  pool.shrink();
  return pool;
}

struct Places {
  PointPool pool;
  Index interior = 0;  ///< the first so many are interior points
};

Places choosePlaces(const PlacementCache& cache, const PlacementOptions& options, const Progress& progress) {
  const SurfaceParts& parts = *cache.parts;
  const Shares wanted = wantedShares(options, parts);
  progress.report("Placing points: inside");
  const PointPool inside = interiorPool(cache, wanted.interior, options, progress);
  const ExteriorPools& exterior = *cache.exterior;
  const Shares shares = fittedShares(
      wanted, options.exteriorShare < 1.0 ? inside.size() : 0,
      options.exteriorShare > 0.0 || inside.size() == 0 ? exterior.outside.size() : 0, exterior.around.size());
  progress.report("Placing points: merging");
  // Side by side: much of merging goes one pair after the other.
  struct Task {
    const PointPool& from;
    Index target;
    Side side;
  };
  const std::array<Task, 3> tasks{Task{inside, shares.interior, Side::inside},
                                  Task{exterior.outside, shares.exterior, Side::outside},
                                  Task{exterior.around, shares.around, Side::outside}};
  std::array<PointPool, 3> pools;
  parallelFor(tasks.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool isReady = &tasks[i].from == &exterior.outside && cache.outside.target == tasks[i].target;
      pools[i] = isReady ? *cache.outside.points
                         : decimatedPool(tasks[i].from, tasks[i].target, tasks[i].side, parts, progress);
    }
  });
  Places places;
  places.interior = pools[0].size();
  for (const PointPool& pool : pools) {
    for (Index i = 0; i < pool.size(); ++i) {
      places.pool.append(pool.points.row(i), pool.parts[i]);
    }
  }
  places.pool.shrink();
  return places;
}

std::vector<ControlPoint> pointsAt(const Places& places, const PlacementOptions& options, double diagonal) {
  // A point alone takes the whole mesh.
  const std::vector<Frame> regions =
      regionsOf(places.pool.points, options.radiusFactor, options.regions, diagonal);
  std::vector<ControlPoint> points(regions.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].id = static_cast<PointId>(i) + 1;
    points[i].kind = static_cast<Index>(i) < places.interior ? PointKind::interior : PointKind::exterior;
    points[i].reach = options.reach;
    points[i].rest = regions[i];
    points[i].pose = regions[i];
  }
  return points;
}

std::string howTaken(const SurfaceParts& parts, Surface how) {
  const Index closed = parts.countOf(true);
  const Index open = parts.countOf(false);
  const char* const reason = how == Surface::automatic ? "" : ", as asked";
  if (open == 0) {
    return format("The surface was taken as closed{}: points lie inside and outside.", reason);
  }
  if (closed == 0) {
    return format("The surface was taken as open{}: points lie on both sides.", reason);
  }
  return format(
      "Of the {} parts, {} {} closed, with points inside and outside, and {} {} open, with points on both "
      "sides.",
      counted(closed + open), counted(closed), closed == 1 ? "is" : "are", counted(open),
      open == 1 ? "is" : "are");
}

std::vector<std::string> remarksOn(const Places& places, const PlacementCache& cache,
                                   const PlacementOptions& options) {
  std::vector<std::string> remarks{howTaken(*cache.parts, options.surface)};
  if (places.pool.size() < options.points) {
    remarks.push_back(
        format("{} of {} points were placed: the surface has no more places for them at an offset of {} "
               "and an exterior share of {}.",
               counted(places.pool.size()), counted(options.points), options.offset, options.exteriorShare));
  }
  if (const Index count = cache.parts->inconsistentCount(); count > 0) {
    remarks.push_back(
        format("{} part{} without a border {} taken as open: {} faces do not agree on which side is out. Make "
               "the normals consistent where the mesh was made, or have the surface taken as closed.",
               counted(count), count == 1 ? "" : "s", count == 1 ? "is" : "are", count == 1 ? "its" : "their"));
  }
  if (cache.parts->count() > options.points) {
    remarks.push_back(format("The mesh has {} separate parts, more than points: some parts share a point.",
                             counted(cache.parts->count())));
  }
  if (cache.parts->countOf(true) > 0 && places.interior == 0 && options.exteriorShare < 1.0) {
    remarks.emplace_back("Nothing is inside the closed surface: all points lie outside.");
  } else if (const Index wanted = wantedShares(options, *cache.parts).interior; places.interior < wanted) {
    remarks.push_back(format("There is room inside for {} of {} points; the others lie outside.",
                             counted(places.interior), counted(wanted)));
  }
  return remarks;
}

/// The points with their regions as placement leaves them, before coverage grows them; all but the cache.
struct Placed {
  PlacementResult result;
  std::vector<ControlPoint> points;
};

Placed placedFrom(const PlacementCache& cache, const PlacementOptions& options, const Progress& progress) {
  Placed placed;
  placed.result.master = makeMaster(*cache.mesh, options.master, options.masterMode);
  placed.result.wanted = options.points;
  placed.result.asClosed = cache.parts->countOf(true) > 0;
  const Places places = choosePlaces(cache, options, progress);
  placed.points = pointsAt(places, options, cache.parts->diagonal());
  placed.result.remarks = remarksOn(places, cache, options);
  return placed;
}

PlacementResult covered(Placed placed, const RestMesh& mesh, const Progress& progress) {
  progress.report("Placing points: regions");
  growCoverage(placed.points, mesh, progress);
  for (ControlPoint& point : placed.points) {
    placed.result.finest.append(std::move(point));
  }
  return std::move(placed.result);
}

void requirePlaceable(const RestMesh& mesh, const PlacementOptions& options, const Progress& progress) {
  requireValid(options);
  progress.throwIfCancelled();
  requirePlaceable(mesh);
}

}  // namespace

PlacementResult placeControlPoints(const std::shared_ptr<const RestMesh>& mesh, const PlacementOptions& options,
                                   const Progress& progress,
                                   const std::shared_ptr<const PlacementCache>& before) {
  requirePlaceable(*mesh, options, progress);
  auto cache = PlacementCache::make(mesh, options, progress, before.get());
  PlacementResult result = covered(placedFrom(*cache, options, progress), *mesh, progress);
  result.cache = std::move(cache);
  return result;
}

PlacementResult placeControlPointsOnce(const std::shared_ptr<const RestMesh>& mesh,
                                       const PlacementOptions& options, const Progress& progress) {
  requirePlaceable(*mesh, options, progress);
  Placed placed = placedFrom(*PlacementCache::make(mesh, options, progress, nullptr), options, progress);
  return covered(std::move(placed), *mesh, progress);
}

}  // namespace pbffd
