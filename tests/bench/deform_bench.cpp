#include "tests/bench/scene.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace pbffd::bench {
namespace {

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

/// One control point after the other moves, all others being moved; range(0): whether normals are taken too.
/// Counted beside it: how many times longer all take in this run.
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
  if (state.range(0) == 0) {
    state.counters["times_faster"] = benchmark::Counter(
        fullPassSeconds(scene, false) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
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

}  // namespace
}  // namespace pbffd::bench
