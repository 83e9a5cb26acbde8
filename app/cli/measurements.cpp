#include "app/cli/measurements.h"

#include "app/yardsticks/brute_force.h"
#include "app/yardsticks/median.h"
#include "core/base/parallel.h"
#include "core/ffd/deform/deformation.h"
#include "core/mesh/spread.h"
#include "core/mesh/voronoi.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace pbffd::cli {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

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
  result.deformAll = medianSeconds([&] { maps = movedMaps(rest, mesh->diagonal(), ++turn); },
                                   [&] { live.updatePositions(maps); }, progress);
  result.deformOne = medianSeconds(
      [&] {
        const auto point = static_cast<std::size_t>(++turn) % maps.points.size();
        maps.points[point].col(3).x() += 0.001 * mesh->diagonal();
      },
      [&] { live.updatePositions(maps); }, progress);
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
  return medianSeconds(
      [&] {
        v.noalias() = w * p;
        v.noalias() += d * a;
      },
      progress);
}

Level withReach(const Level& level, Reach reach) {
  Level changed = level;
  for (Index j = 0; j < level.size(); ++j) {
    ControlPoint point = level[j];
    point.reach = reach;
    changed.replace(j, point);
  }
  return changed;
}

ParameterizeTimes measureParameterization(const RestMesh& mesh, const ControlSet& set, Reach reach,
                                          const Progress& progress) {
  const Level level = withReach(set.finest(), reach);
  const auto byBruteForce = [&] {
    return reach == Reach::all ? weightsByBruteForce(mesh, set.basis, set.master, level)
                               : weightsByWalking(mesh, set.basis, set.master, level);
  };
  Parameterization weights = parameterize(mesh, set.basis, set.master, level, progress);
  ParameterizeTimes times;
  times.difference = greatestDifference(byBruteForce(), weights, mesh);
  times.seconds =
      medianSeconds([&] { weights = parameterize(mesh, set.basis, set.master, level, progress); }, progress);
  times.bruteForce = medianSeconds([&] { byBruteForce(); }, progress);
  return times;
}

}  // namespace

double Measurements::deformBandwidth() const {
  return vertices * (24.0 + 4.0 * influences) / deformAll / triad.bytesPerSecond;
}

std::optional<double> Measurements::timesQhull(double seconds) const {
  return qhull ? std::optional(seconds / *qhull) : std::nullopt;
}

Measurements measure(const Mesh& mesh, const PlacementOptions& options, const Progress& progress) {
  Measurements result;
  result.vertices = mesh.vertexCount();
  std::shared_ptr<const RestMesh> rest;
  PlacementResult placed;
  const auto anew = [&] { rest = std::make_shared<const RestMesh>(mesh); };
  result.assemble = medianSeconds(
      anew, [&] { placed = placeControlPoints(rest, options, progress); }, progress);
  PlacementOptions many = options;
  many.points = Measurements::many;
  result.assembleMany = medianSeconds(
      anew, [&] { result.manyPlaced = placeControlPoints(rest, many, progress).finest.size(); }, progress);
  progress.report("Qhull on every vertex");
  if (!areCoplanar(mesh.positions)) {
    result.qhull = medianSeconds([&] { voronoiVertices(mesh.positions, progress); }, progress);
  }
  const ControlSet set{options.basis, placed.master, {placed.finest}};
  result.points = set.finest().size();
  progress.report("Weights");
  static_cast<void>(rest->blockGraph());
  result.connected = measureParameterization(*rest, set, Reach::connected, progress);
  result.all = measureParameterization(*rest, set, Reach::all, progress);
  result.reach = options.reach;
  const auto weights = std::make_shared<const Parameterization>(
      parameterize(*rest, set.basis, set.master, set.finest(), progress));
  result.influences = influencesOf(*weights);
  progress.report("Deformation");
  result.triad = measureTriad(progress);
  measureDeformation(rest, set, weights, progress, result);
  result.eigenEq7 = measureEq7(*rest, set, progress);
  return result;
}

}  // namespace pbffd::cli
