#include "core/ffd/placement/interior_points.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/ffd/placement/random_order.h"
#include "core/mesh/spread.h"
#include "core/mesh/voronoi.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace pbffd {
namespace {

/// A Voronoi vertex nearer to the surface than this share of the diagonal is a sliver's ...
constexpr double sliverShareOfDiagonal = 0.01;
/// ... unless the part is that thin: half of the radius that is usual in its volume.
constexpr double sliverShareOfUsual = 0.5;

/// The sites of a Voronoi vertex vote by their normals; the vote counts when all agree and none of the normals
/// stands across the way to the vertex. Measured: then 0 to 0.01 % of the votes on a simple closed mesh are
/// wrong, but 2 % where shells lie in each other, and 0.1 % where a mesh runs through itself.
constexpr double clearVote = 0.4;
/// One vote in so many is checked by the winding number; if any is wrong, none counts.
constexpr std::uint64_t votesToCheck = 16;

enum class Vote : std::uint8_t { open, inside, outside };

Vote voteOn(Index vertex, const SurfaceSamples& sites, const VoronoiVertices& vertices) {
  double least = 1.0;
  double greatest = -1.0;
  for (const Index site : vertices.sites(vertex)) {
    const double cosine =
        (vertices.positions.row(vertex) - sites.positions.row(site)).dot(sites.normals.row(site)) /
        vertices.radii[static_cast<std::size_t>(vertex)];
    least = std::min(least, cosine);
    greatest = std::max(greatest, cosine);
  }
  return greatest < -clearVote ? Vote::inside : least > clearVote ? Vote::outside : Vote::open;
}

/// The radius that half of the volume is on either side of, each ball counting with its volume.
double usualRadius(std::vector<double> radii) {
  std::sort(radii.begin(), radii.end());
  double total = 0.0;
  for (const double radius : radii) {
    total += radius * radius * radius;
  }
  double below = 0.0;
  for (const double radius : radii) {
    below += radius * radius * radius;
    if (below >= 0.5 * total) {
      return radius;
    }
  }
  return 0.0;
}

/// The parts whose usual radius is large enough for sliverShareOfDiagonal, so that the inside of smaller balls
/// need not be known: also if all of them were inside, the larger ones hold half of the volume.
std::vector<bool> partsWithLargeBalls(const SurfaceParts& parts, const SurfaceSamples& sites,
                                      const VoronoiVertices& vertices, const std::vector<bool>& isInside) {
  const double diagonal = parts.diagonal();
  const double large = sliverShareOfDiagonal / sliverShareOfUsual;
  std::vector<double> below(static_cast<std::size_t>(parts.count()), 0.0);
  std::vector<double> total(below.size(), 0.0);
  for (Index v = 0; v < vertices.size(); ++v) {
    const double radius = vertices.radii[v] / diagonal;
    if (isInside[v] || radius < sliverShareOfDiagonal) {
      const Index part = sites.parts[vertices.sites(v)[0]];
      const double cube = radius * radius * radius;
      total[part] += cube;
      below[part] += radius < large ? cube : 0.0;
    }
  }
  std::vector<bool> isLarge;
  for (std::size_t part = 0; part < total.size(); ++part) {
    isLarge.push_back(below[part] < 0.5 * total[part]);
  }
  return isLarge;
}

/// The distance from the surface below which a Voronoi vertex of a part counts as a sliver's. inside: those
/// of its vertices that are inside.
double sliverRadius(const SurfaceParts& parts, const VoronoiVertices& vertices,
                    const std::vector<Index>& inside) {
  const double diagonal = parts.diagonal();
  std::vector<double> radii;
  radii.reserve(inside.size());
  for (const Index v : inside) {
    radii.push_back(vertices.radii[v] / diagonal);
  }
  return diagonal * std::min(sliverShareOfDiagonal, sliverShareOfUsual * usualRadius(std::move(radii)));
}

/// The Voronoi vertices inside that are no slivers'.
PointPool volumePoints(const SurfaceParts& parts, const SurfaceSamples& sites, const VoronoiVertices& vertices,
                       const Progress& progress) {
  const double least = sliverShareOfDiagonal * parts.diagonal();
  std::vector<bool> isInside(static_cast<std::size_t>(vertices.size()), false);
  const auto decide = [&](const auto& isAsked) {
    std::vector<Index> rows;
    for (Index v = 0; v < vertices.size(); ++v) {
      if (isAsked(v)) {
        rows.push_back(v);
      }
    }
    const std::vector<bool> flags = insideFlags(rows, parts, sites, vertices, progress);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      isInside[rows[i]] = flags[i];
    }
  };
  const auto partOf = [&](Index v) { return sites.parts[vertices.sites(v)[0]]; };
  decide([&](Index v) { return vertices.radii[v] >= least; });
  const std::vector<bool> isLarge = partsWithLargeBalls(parts, sites, vertices, isInside);
  decide([&](Index v) { return vertices.radii[v] < least && !isLarge[partOf(v)]; });

  std::vector<std::vector<Index>> insideOfPart(isLarge.size());
  for (Index v = 0; v < vertices.size(); ++v) {
    if (isInside[v] && !isLarge[partOf(v)]) {
      insideOfPart[partOf(v)].push_back(v);
    }
  }
  std::vector<double> limits;
  for (std::size_t part = 0; part < isLarge.size(); ++part) {
    limits.push_back(isLarge[part] ? least : sliverRadius(parts, vertices, insideOfPart[part]));
  }
  PointPool kept;
  for (Index v = 0; v < vertices.size(); ++v) {
    if (isInside[v] && vertices.radii[v] >= limits[partOf(v)]) {
      kept.append(vertices.positions.row(v), partOf(v));
    }
  }
  kept.dropDoubles();
  return kept;
}

}  // namespace

std::vector<bool> insideFlags(const std::vector<Index>& rows, const SurfaceParts& parts,
                              const SurfaceSamples& sites, const VoronoiVertices& vertices,
                              const Progress& progress) {
  std::vector<Vote> votes(rows.size(), Vote::open);
  if (parts.countOf(true) == 1) {
    parallelFor(rows.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        votes[i] = voteOn(rows[i], sites, vertices);
      }
    });
  }
  std::vector<std::size_t> open;
  std::vector<std::size_t> sample;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (votes[i] == Vote::open) {
      open.push_back(i);
    } else if (scrambled(static_cast<std::uint64_t>(rows[i])) % votesToCheck == 0) {
      sample.push_back(i);
    }
  }
  std::vector<bool> isInside(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    isInside[i] = votes[i] == Vote::inside;
  }
  const auto byWinding = [&](const std::vector<std::size_t>& some) {
    Points points(static_cast<Index>(some.size()), 3);
    for (std::size_t k = 0; k < some.size(); ++k) {
      points.row(static_cast<Index>(k)) = vertices.positions.row(rows[some[k]]);
    }
    return parts.likelyInsideFlags(points, progress);
  };
  const std::vector<bool> checked = byWinding(sample);
  for (std::size_t k = 0; k < sample.size(); ++k) {
    if (checked[k] != isInside[sample[k]]) {
      open.resize(rows.size());
      std::iota(open.begin(), open.end(), std::size_t{0});
      break;
    }
  }
  const std::vector<bool> decided = byWinding(open);
  for (std::size_t k = 0; k < open.size(); ++k) {
    isInside[open[k]] = decided[k];
  }
  return isInside;
}

PointPool voronoiPointsInside(const SurfaceParts& parts, const SurfaceSamples& sites,
                              const Progress& progress) {
  if (sites.size() < 4 || areCoplanar(sites.positions)) {
    return {};
  }
  VoronoiVertices vertices;
  try {
    vertices = voronoiVertices(sites.positions, progress);
  } catch (const SolverError&) {
    // Points spread over the inside take their place.
    return {};
  }
  progress.report("Placing points: inside");
  return volumePoints(parts, sites, vertices, progress);
}

}  // namespace pbffd
