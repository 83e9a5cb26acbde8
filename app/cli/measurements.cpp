#include "app/cli/measurements.h"

#include "core/base/parallel.h"
#include "core/ffd/deform/deformation.h"
#include "core/ffd/weights/large_array.h"
#include "core/mesh/spread.h"
#include "core/mesh/voronoi.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <functional>
#include <vector>

namespace pbffd::cli {
namespace {

using Clock = std::chrono::steady_clock;
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// How often a step is run: at least three times, longer for what is over quickly, less for what is not.
constexpr int leastRuns = 3;
constexpr int mostRuns = 101;
constexpr double enoughSeconds = 0.5;
constexpr double tooManySeconds = 20.0;

/// The median time of `work`; `prepare` is run before each and not counted.
double medianSeconds(const Progress& progress, const std::function<void()>& prepare,
                     const std::function<void()>& work) {
  std::vector<double> seconds;
  double sum = 0.0;
  const auto isEnough = [&] {
    const auto runs = static_cast<int>(seconds.size());
    return runs >= mostRuns || (runs >= leastRuns && sum >= enoughSeconds) ||
           (runs > 0 && sum >= tooManySeconds);
  };
  while (!isEnough()) {
    progress.throwIfCancelled();
    prepare();
    const Clock::time_point start = Clock::now();
    work();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    sum += seconds.back();
  }
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

double medianSeconds(const Progress& progress, const std::function<void()>& work) {
  return medianSeconds(
      progress, [] {}, work);
}

/// STREAM's triad, a = b + s c, on all cores, with arrays far larger than the caches, in the same kind of
/// memory as the weights.
double measureTriad(const Progress& progress) {
  constexpr std::size_t count = std::size_t{1} << 24;
  LargeArray<float> a(count, 0.0F);
  const LargeArray<float> b(count, 1.0F);
  const LargeArray<float> c(count, 2.0F);
  const double seconds = medianSeconds(progress, [&] {
    parallelFor(count, count / 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        a[i] = b[i] + 3.0F * c[i];
      }
    });
  });
  return 3.0 * sizeof(float) * count / seconds;
}

/// Every vertex against every control point, keeping nothing but sums: what parameterize() would take without
/// its search.
double measureBruteForce(const RestMesh& mesh, const ControlSet& set, const Progress& progress) {
  std::vector<Region> regions;
  for (const ControlPoint& point : set.finest()) {
    regions.emplace_back(point.rest);
  }
  std::vector<double> sums(static_cast<std::size_t>(mesh.vertexCount()));
  return medianSeconds(progress, [&] {
    parallelFor(sums.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        const Vec3 vertex = mesh.positions().row(static_cast<Eigen::Index>(v));
        sums[v] = set.master.value;
        for (const Region& region : regions) {
          sums[v] += basisValue(set.basis, region.squaredDistance(vertex));
        }
      }
    });
  });
}

double influencesOf(const Parameterization& weights) {
  double sum = 0.0;
  for (const std::uint16_t members : weights.members) {
    sum += std::popcount(members);
  }
  return sum / std::max<Index>(weights.vertexCount, 1);
}

/// Every map turned and moved a little, by another amount each time.
LevelMaps movedMaps(LevelMaps maps, double size, int turn) {
  for (std::size_t j = 0; j < maps.points.size(); ++j) {
    const double angle = 0.01 * static_cast<double>(1 + (j + static_cast<std::size_t>(turn)) % 7);
    maps.points[j].col(3) += 0.01 * size * Vec3(std::sin(angle), std::cos(angle), angle);
    maps.points[j].leftCols<2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle), 0, 0;
  }
  return maps;
}

void measureDeformation(const std::shared_ptr<const RestMesh>& mesh, const ControlSet& set,
                        const std::shared_ptr<const Parameterization>& weights, const Progress& progress,
                        Measurements& result) {
  LiveDeformation live(mesh, weights);
  const LevelMaps rest = mapsOf(set, set.finest());
  LevelMaps maps;
  int turn = 0;
  result.deformAll = medianSeconds(
      progress, [&] { maps = movedMaps(rest, mesh->diagonal(), ++turn); }, [&] { live.updatePositions(maps); });
  result.deformOne = medianSeconds(
      progress,
      [&] {
        const auto point = static_cast<std::size_t>(++turn) % maps.points.size();
        maps.points[point].col(3).x() += 0.001 * mesh->diagonal();
      },
      [&] { live.updatePositions(maps); });
}

/// W and D of McDonnell & Qin, eq. (7), the master in their last columns.
std::pair<SparseMatrix, SparseMatrix> matricesOfEq7(const RestMesh& mesh, const ControlSet& set,
                                                    const Progress& progress) {
  const Level& level = set.finest();
  const Points& vertices = mesh.positions();
  const PointWeights rows = weightsAt(vertices, mesh, set.basis, set.master, level, progress);
  std::vector<Region> regions;
  for (const ControlPoint& point : level) {
    regions.emplace_back(point.rest);
  }
  regions.emplace_back(set.master.rest);
  const Index columns = level.size() + 1;
  std::vector<Eigen::Triplet<double>> inW;
  std::vector<Eigen::Triplet<double>> inD;
  const auto add = [&](Index vertex, Index column, double weight) {
    const Vec3 u = regions[static_cast<std::size_t>(column)].parameter(vertices.row(vertex));
    inW.emplace_back(vertex, column, weight);
    for (Index axis = 0; axis < 3; ++axis) {
      inD.emplace_back(vertex, axis * columns + column, weight * u[axis]);
    }
  };
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
    for (Index entry = rows.start[vertex]; entry < rows.start[vertex + 1]; ++entry) {
      add(vertex, rows.points[entry], rows.weights[entry]);
    }
    add(vertex, columns - 1, rows.master[vertex]);
  }
  SparseMatrix w(mesh.vertexCount(), columns);
  SparseMatrix d(mesh.vertexCount(), 3 * columns);
  w.setFromTriplets(inW.begin(), inW.end());
  d.setFromTriplets(inD.begin(), inD.end());
  return {std::move(w), std::move(d)};
}

double measureEq7(const RestMesh& mesh, const ControlSet& set, const Progress& progress) {
  const auto [w, d] = matricesOfEq7(mesh, set, progress);
  const Eigen::MatrixXd p = Eigen::MatrixXd::Constant(w.cols(), 3, 1.0);
  const Eigen::MatrixXd a = Eigen::MatrixXd::Constant(d.cols(), 3, 0.5);
  Eigen::MatrixXd v(w.rows(), 3);
  const ThreadLimit one(1);
  return medianSeconds(progress, [&] {
    v.noalias() = w * p;
    v.noalias() += d * a;
  });
}

}  // namespace

double Measurements::deformBandwidth() const {
  return vertices * (24.0 + 4.0 * influences) / deformAll / triadBytesPerSecond;
}

std::optional<double> Measurements::timesQhull(double seconds) const {
  return qhull ? std::optional(seconds / *qhull) : std::nullopt;
}

Measurements measure(const Mesh& mesh, const PlacementOptions& options, const Progress& progress) {
  Measurements result;
  result.vertices = mesh.vertexCount();
  std::shared_ptr<const RestMesh> rest;
  PlacementResult placed;
  result.assemble = medianSeconds(
      progress, [&] { rest = std::make_shared<const RestMesh>(mesh); },
      [&] { placed = placeControlPoints(rest, options, progress); });
  PlacementOptions many = options;
  many.points = Measurements::many;
  result.assembleMany = medianSeconds(
      progress, [&] { rest = std::make_shared<const RestMesh>(mesh); },
      [&] { placeControlPoints(rest, many, progress); });
  progress.report("Qhull on every vertex");
  if (!areCoplanar(mesh.positions)) {
    result.qhull = medianSeconds(progress, [&] { voronoiVertices(mesh.positions, progress); });
  }
  const ControlSet set{options.basis, placed.master, {placed.finest}};
  result.points = set.finest().size();
  progress.report("Weights");
  std::shared_ptr<const Parameterization> weights;
  result.parameterize = medianSeconds(progress, [&] {
    weights = std::make_shared<const Parameterization>(
        parameterize(*rest, set.basis, set.master, set.finest(), progress));
  });
  result.influences = influencesOf(*weights);
  result.bruteForce = measureBruteForce(*rest, set, progress);
  progress.report("Deformation");
  result.triadBytesPerSecond = measureTriad(progress);
  measureDeformation(rest, set, weights, progress, result);
  result.eigenEq7 = measureEq7(*rest, set, progress);
  return result;
}

}  // namespace pbffd::cli
