#include "tests/bench/scene.h"

#include <benchmark/benchmark.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <memory>

namespace pbffd::bench {
namespace {

/// Every control point moved by a little, one way or the other; turned too where asked for.
LevelMaps movedMaps(const Scene& scene, bool turned, double amount) {
  LevelMaps maps = mapsOf(scene.set, scene.set.finest());
  for (std::size_t j = 0; j < maps.points.size(); ++j) {
    const double angle = 0.1 * amount * static_cast<double>(1 + j % 7);
    maps.points[j].col(3) += amount * Vec3(std::sin(angle), 0.01, -0.02) * scene.mesh->diagonal();
    if (turned) {
      maps.points[j].leftCols<2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle), 0, 0;
    }
  }
  return maps;
}

std::shared_ptr<const Parameterization> sharedWeights(Scene& scene) {
  scene.setReach(Reach::all);
  return std::make_shared<const Parameterization>(scene.weights());
}

/// The bytes that a full pass must move: rest and new positions, 4 bytes an influence.
double bytesOfPass(const Scene& scene) {
  return scene.mesh->vertexCount() * (24.0 + 4.0 * scene.influences);
}

void triad(benchmark::State& state) {
  double best = 0.0;
  for (auto _ : state) {
    best = std::max(best, triadBytesPerSecond());
  }
  state.counters["bytes_per_second"] = benchmark::Counter(best);
}
BENCHMARK(triad)->Unit(benchmark::kMillisecond)->UseRealTime();

/// state.range(0): whether frames turn; range(1): the instructions.
void fullPass(benchmark::State& state) {
  Scene& scene = theScene();
  const auto instructions = static_cast<Instructions>(state.range(1));
  if (liveKernel(instructions) == nullptr) {
    state.SkipWithError("this processor does not have the instructions");
    return;
  }
  LiveDeformation live(scene.mesh, sharedWeights(scene), instructions);
  const LevelMaps maps[2] = {movedMaps(scene, state.range(0) != 0, 0.1),
                             movedMaps(scene, state.range(0) != 0, 0.2)};
  int turn = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(live.updatePositions(maps[turn ^= 1]));
  }
  state.SetBytesProcessed(
      static_cast<std::int64_t>(bytesOfPass(scene) * static_cast<double>(state.iterations())));
  double triadRate = 0.0;
  for (int i = 0; i < 5; ++i) {
    triadRate = std::max(triadRate, triadBytesPerSecond());
  }
  state.counters["of_triad"] = benchmark::Counter(
      bytesOfPass(scene) * static_cast<double>(state.iterations()) / triadRate, benchmark::Counter::kIsRate);
}
BENCHMARK(fullPass)
    ->ArgNames({"turned", "instructions"})
    ->ArgsProduct({{0, 1}, {0, 1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void fullPassWithNormals(benchmark::State& state) {
  Scene& scene = theScene();
  LiveDeformation live(scene.mesh, sharedWeights(scene));
  const LevelMaps maps[2] = {movedMaps(scene, true, 0.1), movedMaps(scene, true, 0.2)};
  int turn = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(live.update(maps[turn ^= 1]));
  }
  state.counters["bytes_a_vertex"] = static_cast<double>(live.bytesOfWeights()) / scene.mesh->vertexCount();
}
BENCHMARK(fullPassWithNormals)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One control point after the other moves; range(0): whether normals are taken too.
void dragOnePoint(benchmark::State& state) {
  Scene& scene = theScene();
  LiveDeformation live(scene.mesh, sharedWeights(scene));
  LevelMaps maps = movedMaps(scene, false, 0.1);
  live.update(maps);
  std::size_t j = 0;
  for (auto _ : state) {
    maps.points[j].col(3).x() += 0.001 * scene.mesh->diagonal();
    benchmark::DoNotOptimize(state.range(0) != 0 ? live.update(maps) : live.updatePositions(maps));
    j = (j + 1) % maps.points.size();
  }
}
BENCHMARK(dragOnePoint)->ArgName("normals")->Arg(0)->Arg(1)->Unit(benchmark::kMicrosecond)->UseRealTime();

void makeLive(benchmark::State& state) {
  Scene& scene = theScene();
  const auto weights = sharedWeights(scene);
  for (auto _ : state) {
    benchmark::DoNotOptimize(LiveDeformation(scene.mesh, weights));
  }
}
BENCHMARK(makeLive)->Unit(benchmark::kMillisecond)->UseRealTime();

void deformExactlyInDouble(benchmark::State& state) {
  Scene& scene = theScene();
  const auto weights = sharedWeights(scene);
  ControlSet set = scene.set;
  for (Index j = 0; j < set.finest().size(); ++j) {
    ControlPoint point = set.finest()[j];
    point.pose.center.x() += 0.01 * scene.mesh->diagonal();
    set.levels[0].replace(j, point);
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(deformExactly(*scene.mesh, set, *weights));
  }
}
BENCHMARK(deformExactlyInDouble)->Unit(benchmark::kMillisecond)->UseRealTime();

/// McDonnell & Qin, eq. (7) by the letter, V = WP + DA, sparse and in double precision, on one thread.
void eigenEquationSeven(benchmark::State& state) {
  Scene& scene = theScene();
  scene.setReach(Reach::all);
  const Level& level = scene.set.finest();
  const Points& vertices = scene.mesh->positions();
  const PointWeights rows = weightsAt(vertices, *scene.mesh, scene.set.basis, scene.set.master, level);
  const Index count = level.size() + 1;
  std::vector<Eigen::Triplet<double>> inW;
  std::vector<Eigen::Triplet<double>> inD;
  const auto add = [&](Index i, Index j, double weight, const Frame& rest) {
    const Vec3 u = Region(rest).parameter(vertices.row(i));
    inW.emplace_back(i, j, weight);
    for (int axis = 0; axis < 3; ++axis) {
      inD.emplace_back(i, axis * count + j, weight * u[axis]);
    }
  };
  for (Index i = 0; i < vertices.rows(); ++i) {
    for (Index e = rows.start[i]; e < rows.start[i + 1]; ++e) {
      add(i, rows.points[e], rows.weights[e], level[rows.points[e]].rest);
    }
    add(i, count - 1, rows.master[i], scene.set.master.rest);
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> w(vertices.rows(), count);
  Eigen::SparseMatrix<double, Eigen::RowMajor> d(vertices.rows(), 3 * count);
  w.setFromTriplets(inW.begin(), inW.end());
  d.setFromTriplets(inD.begin(), inD.end());
  const Eigen::MatrixXd p = Eigen::MatrixXd::Random(count, 3);
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(3 * count, 3);
  Eigen::MatrixXd v(vertices.rows(), 3);
  for (auto _ : state) {
    v.noalias() = w * p;
    v.noalias() += d * a;
    benchmark::ClobberMemory();
  }
}
BENCHMARK(eigenEquationSeven)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace pbffd::bench
