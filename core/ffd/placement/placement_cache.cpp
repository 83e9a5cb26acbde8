#include "core/ffd/placement/placement_cache.h"

#include "core/base/parallel.h"
#include "core/ffd/placement/shares.h"

#include <algorithm>
#include <future>

namespace pbffd {
namespace {

/// The numbers of points are taken in a few classes, so that the same sites serve a whole range of a slider
/// and yet do not depend on where it stood before.
Index classOf(int points) {
  for (const Index limit : {2000, 5000, 10000}) {
    if (points <= limit) {
      return limit;
    }
  }
  return 20000;
}

/// Exterior points want a choice of places, also where few Voronoi sites were asked for.
Index exteriorPlaces(int points) {
  return 3 * classOf(points) / 2;
}

/// More sites than 6,000 change where 200 points lie by less than the distance between sites, and cost more
/// than the rest of placement. Of many points each wants a choice of places, of which a site gives about three
/// inside.
Index sensibleSiteCount(int points) {
  constexpr Index least = 6000;
  return std::max(least, exteriorPlaces(points));
}

/// A mesh of fewer vertices says too little of its shape by them alone: the faces are sampled too.
constexpr Index fewVertices = 600;
constexpr Index sitesOfFewVertices = 1500;

/// The vertices that are sites.
SurfaceSamples vertexSites(const SurfaceParts& parts, const PlacementCache::Ground& ground,
                           const Progress& progress) {
  return ground.sites == 0 ? everyVertex(parts) : spacedVertices(parts, ground.sites, ground.seed, progress);
}

/// For the Voronoi diagram.
SurfaceSamples sitesFrom(const SurfaceSamples& vertices, const SurfaceParts& parts,
                         const PlacementCache::Ground& ground) {
  return samplesOf(parts,
                   parts.mesh().vertexCount() < fewVertices
                       ? withFaceSamples(parts, vertices, sitesOfFewVertices, ground.seed)
                       : vertices,
                   true);
}

/// Where exterior points start.
SurfaceSamples startsFrom(const SurfaceSamples& vertices, const SurfaceParts& parts,
                          const PlacementCache::Ground& ground, const Progress& progress) {
  if (vertices.size() >= ground.places) {
    return vertices;
  }
  return withFaceSamples(parts, spacedVertices(parts, ground.places, ground.seed, progress), ground.places,
                         ground.seed);
}

PlacementCache::Outside chooseOutside(const PointPool& pool, const PlacementOptions& options,
                                      const SurfaceParts& parts, const Progress& progress) {
  const Index target = std::min(wantedShares(options, parts).exterior, pool.size());
  return {target,
          std::make_shared<const PointPool>(decimatedPool(pool, target, Side::outside, parts, progress))};
}

/// The exterior points, and what follows from them and the mesh alone.
struct Exterior {
  std::shared_ptr<const ExteriorPools> pools;
  PlacementCache::Outside outside;
};

/// Has the mesh work out what the regions will ask for.
void warmUp(const RestMesh& mesh, Reach reach) {
  static_cast<void>(mesh.mortonOrder());
  if (reach == Reach::connected) {
    static_cast<void>(mesh.blockGraph());
  }
}

}  // namespace

std::shared_ptr<const PlacementCache> PlacementCache::make(const std::shared_ptr<const RestMesh>& mesh,
                                                           const PlacementOptions& options,
                                                           const Progress& progress,
                                                           const PlacementCache* before) {
  if (before != nullptr && before->mesh != mesh) {
    before = nullptr;
  }
  auto made = std::make_shared<PlacementCache>();
  made->mesh = mesh;
  made->ground = {options.surface, options.sites.value_or(sensibleSiteCount(options.points)),
                  exteriorPlaces(options.points), options.seed};
  made->offset = options.offset;
  if (before != nullptr && before->ground.surface == options.surface) {
    made->parts = before->parts;
  } else {
    progress.report("Placing points: surface");
    made->parts = std::make_shared<const SurfaceParts>(mesh, options.surface);
  }
  const bool sameGround = before != nullptr && before->ground == made->ground;
  if (sameGround && before->offset == options.offset) {
    made->interior = before->interior;
    made->exterior = before->exterior;
    made->outside = before->outside;
    return made;
  }
  progress.throwIfCancelled();
  const SurfaceParts& parts = *made->parts;
  progress.report("Placing points: sites");
  const SurfaceSamples vertices = vertexSites(parts, made->ground, progress);
  const auto makeExterior = [&] {
    Exterior exterior;
    const auto make = [&] {
      exterior.pools = std::make_shared<const ExteriorPools>(exteriorPools(
          parts, startsFrom(vertices, parts, made->ground, progress), options.offset * parts.diagonal(), progress));
      if (!sameGround) {
        exterior.outside = chooseOutside(exterior.pools->outside, options, parts, progress);
        warmUp(*mesh, options.reach);
      }
    };
    if (sameGround) {
      make();
    } else {
      onThisThreadAlone(make);
    }
    return exterior;
  };
  // Beside the interior points, on one core, since Qhull knows one thread only. That one stays this one: its
  // memory is at hand again the next time.
  std::future<Exterior> exterior =
      std::async(sameGround ? std::launch::deferred : std::launch::async, makeExterior);
  made->interior = sameGround ? before->interior
                              : std::make_shared<const PointPool>(voronoiPointsInside(
                                    parts, sitesFrom(vertices, parts, made->ground), progress));
  const Exterior around = exterior.get();
  made->exterior = around.pools;
  made->outside = around.outside;
  return made;
}

}  // namespace pbffd
