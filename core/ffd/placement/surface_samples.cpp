#include "core/ffd/placement/surface_samples.h"

#include "core/ffd/placement/random_order.h"
#include "core/ffd/placement/spaced_picks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pbffd {
namespace {

/// Dart throwing fills a plane until about 0.7 picks a spacing squared.
constexpr double picksPerSquaredSpacing = 0.7;

/// Where the surface bends, sites stand at this share of the radius of curvature ...
constexpr double shareOfCurvatureRadius = 0.6;
/// ... but no closer than this share of the usual spacing.
constexpr double leastShareOfSpacing = 0.35;

/// How sharply the surface turns at each vertex: the greatest angle between normals by length of edge.
std::vector<double> curvatures(const SurfaceParts& parts) {
  const RestMesh& mesh = parts.mesh();
  const std::span<const Index> corners = mesh.triangles().vertices();
  std::vector<double> curvature(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = corners[t + k];
      const Index b = corners[t + (k + 1) % 3];
      const double length = (mesh.positions().row(a) - mesh.positions().row(b)).norm();
      if (length > 0.0) {
        const double turn = (mesh.normals().row(a) - mesh.normals().row(b)).norm() / length;
        curvature[a] = std::max(curvature[a], turn);
        curvature[b] = std::max(curvature[b], turn);
      }
    }
  }
  return curvature;
}

/// A third of the area of the triangles around each vertex.
std::vector<double> areasAround(const SurfaceParts& parts) {
  const RestMesh& mesh = parts.mesh();
  const std::span<const Index> corners = mesh.triangles().vertices();
  std::vector<double> areas(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    const auto at = [&](std::size_t k) -> Vec3 { return mesh.positions().row(corners[t + k]); };
    const double area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
    for (std::size_t k = 0; k < 3; ++k) {
      areas[corners[t + k]] += area / 3.0;
    }
  }
  return areas;
}

/// The spacing wanted at each vertex so that about `count` picks result.
std::vector<double> spacings(const SurfaceParts& parts, Index count) {
  const std::vector<double> curvature = curvatures(parts);
  const std::vector<double> areas = areasAround(parts);
  const double area = parts.areaOf(true) + parts.areaOf(false);
  const double usual = std::sqrt(picksPerSquaredSpacing * area / count);
  std::vector<double> spacing(curvature.size(), usual);
  double weighted = 0.0;
  for (std::size_t v = 0; v < spacing.size(); ++v) {
    if (curvature[v] > 0.0) {
      spacing[v] = std::clamp(shareOfCurvatureRadius / curvature[v], leastShareOfSpacing * usual, usual);
    }
    weighted += areas[v] / (spacing[v] * spacing[v]);
  }
  const double scale = weighted > 0.0 ? std::sqrt(picksPerSquaredSpacing * weighted / count) : 1.0;
  for (double& s : spacing) {
    s *= scale;
  }
  return spacing;
}

std::vector<Index> verticesWithFaces(const SurfaceParts& parts) {
  std::vector<Index> vertices;
  for (Index v = 0; v < parts.mesh().vertexCount(); ++v) {
    if (parts.partOfVertex()[v] >= 0) {
      vertices.push_back(v);
    }
  }
  return vertices;
}

SurfaceSamples samplesAt(const SurfaceParts& parts, const std::vector<Index>& vertices) {
  SurfaceSamples samples;
  const auto count = static_cast<Index>(vertices.size());
  samples.positions.resize(count, 3);
  samples.normals.resize(count, 3);
  for (Index i = 0; i < count; ++i) {
    samples.positions.row(i) = parts.mesh().positions().row(vertices[i]);
    samples.normals.row(i) = parts.vertexNormal(vertices[i]);
    samples.parts.push_back(parts.partOfVertex()[vertices[i]]);
  }
  return samples;
}

/// Throws darts with spacings times `scale`, after those that `isPicked` already; stops when `count` are
/// picked. The numbers of the picks.
class Thrower {
 public:
  Thrower(const SurfaceParts& parts, const std::vector<Index>& vertices, const std::vector<double>& spacing,
          const RandomOrder& order)
      : parts_(parts), vertices_(vertices), spacing_(spacing), order_(order) {}

  std::vector<Index> pick(double scale, Index count, const std::vector<Index>& before) const {
    double widest = 0.0;
    for (const Index v : vertices_) {
      widest = std::max(widest, scale * spacing_[v]);
    }
    SpacedPicks picks(parts_.bounds().low, parts_.bounds().high, widest);
    std::vector<Index> picked;
    std::vector<bool> isPicked(spacing_.size(), false);
    for (const Index v : before) {
      // Those before stood wider apart, so none is refused but doubles.
      picks.pick(candidate(v, scale));
      picked.push_back(v);
      isPicked[v] = true;
    }
    for (std::size_t i = 0; i < vertices_.size() && static_cast<Index>(picked.size()) < count; ++i) {
      const Index v = vertices_[order_[i]];
      if (!isPicked[v] && picks.pick(candidate(v, scale))) {
        picked.push_back(v);
      }
    }
    return picked;
  }

 private:
  SpacedPicks::Candidate candidate(Index v, double scale) const {
    return {parts_.mesh().positions().row(v), parts_.vertexNormal(v), parts_.partOfVertex()[v],
            scale * spacing_[v]};
  }

  const SurfaceParts& parts_;
  const std::vector<Index>& vertices_;
  const std::vector<double>& spacing_;
  const RandomOrder& order_;
};

}  // namespace

SurfaceSamples everyVertex(const SurfaceParts& parts) {
  return samplesAt(parts, verticesWithFaces(parts));
}

SurfaceSamples spacedVertices(const SurfaceParts& parts, Index count, unsigned seed, const Progress& progress) {
  const std::vector<Index> vertices = verticesWithFaces(parts);
  const auto total = static_cast<Index>(vertices.size());
  if (total <= count) {
    return samplesAt(parts, vertices);
  }
  const std::vector<double> spacing = spacings(parts, count);
  const RandomOrder order(vertices.size(), seed);
  const Thrower thrower(parts, vertices, spacing, order);
  double scale = 1.0;
  std::vector<Index> picked;
  // Wider until too few find room, then filled up at closer and closer spacing.
  for (int attempt = 0; attempt < 20; ++attempt) {
    progress.throwIfCancelled();
    picked = thrower.pick(scale, count + count / 2, {});
    if (static_cast<Index>(picked.size()) <= count) {
      break;
    }
    scale *= 1.02 * std::sqrt(static_cast<double>(picked.size()) / count);
  }
  picked.resize(std::min(picked.size(), static_cast<std::size_t>(count)));
  for (int attempt = 0; attempt < 12 && static_cast<Index>(picked.size()) < count; ++attempt) {
    progress.throwIfCancelled();
    scale *= 0.75;
    picked = thrower.pick(scale, count, picked);
  }
  std::sort(picked.begin(), picked.end());
  return samplesAt(parts, picked);
}

SurfaceSamples withFaceSamples(const SurfaceParts& parts, const SurfaceSamples& samples, Index count,
                               unsigned seed) {
  if (samples.size() >= count) {
    return samples;
  }
  // Four darts for each that finds room; thrown by area, the faces in their order.
  const RestMesh& mesh = parts.mesh();
  const std::span<const Index> corners = mesh.triangles().vertices();
  const double area = parts.areaOf(true) + parts.areaOf(false);
  const auto darts = 4 * static_cast<std::uint64_t>(count);
  const double spacing = std::sqrt(picksPerSquaredSpacing * area / count);
  std::vector<SpacedPicks::Candidate> candidates;
  double done = 0.0;
  for (Index t = 0; t < mesh.triangles().size(); ++t) {
    const auto at = [&](int k) -> Vec3 { return mesh.positions().row(corners[3 * t + k]); };
    const double before = done;
    done += area > 0.0 ? 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm() / area : 0.0;
    const auto last = static_cast<std::uint64_t>(done * static_cast<double>(darts));
    for (auto i = static_cast<std::uint64_t>(before * static_cast<double>(darts)); i < last; ++i) {
      const double root = std::sqrt(randomShare(seed, 2 * i));
      const double along = randomShare(seed, 2 * i + 1);
      candidates.push_back({(1.0 - root) * at(0) + root * (1.0 - along) * at(1) + root * along * at(2),
                            parts.triangleNormal(t), parts.partOfTriangle()[t], spacing});
    }
  }
  SpacedPicks picks(parts.bounds().low, parts.bounds().high, spacing);
  for (Index i = 0; i < samples.size(); ++i) {
    picks.pick({samples.positions.row(i), samples.normals.row(i), samples.parts[i], spacing});
  }
  SurfaceSamples result = samples;
  const RandomOrder order(candidates.size(), seed);
  std::vector<SpacedPicks::Candidate> found;
  for (std::size_t i = 0; i < candidates.size() && samples.size() + static_cast<Index>(found.size()) < count;
       ++i) {
    if (picks.pick(candidates[order[i]])) {
      found.push_back(candidates[order[i]]);
    }
  }
  const auto total = samples.size() + static_cast<Index>(found.size());
  result.positions.conservativeResize(total, 3);
  result.normals.conservativeResize(total, 3);
  for (const auto& one : found) {
    result.positions.row(result.size()) = one.position;
    result.normals.row(result.size()) = one.normal;
    result.parts.push_back(one.part);
  }
  return result;
}

SurfaceSamples samplesOf(const SurfaceParts& parts, const SurfaceSamples& samples, bool closed) {
  SurfaceSamples some;
  some.positions.resize(samples.size(), 3);
  some.normals.resize(samples.size(), 3);
  for (Index i = 0; i < samples.size(); ++i) {
    if (parts.isClosed(samples.parts[i]) == closed) {
      some.positions.row(some.size()) = samples.positions.row(i);
      some.normals.row(some.size()) = samples.normals.row(i);
      some.parts.push_back(samples.parts[i]);
    }
  }
  some.positions.conservativeResize(some.size(), 3);
  some.normals.conservativeResize(some.size(), 3);
  return some;
}

}  // namespace pbffd
