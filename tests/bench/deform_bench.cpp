#include "app/yardsticks/median.h"
#include "tests/bench/scene.h"

#include <benchmark/benchmark.h>

namespace pbffd::bench {
namespace {

/// The bytes that a full pass must move: rest and new positions, 4 bytes an influence.
double bytesOfPass(const Scene& scene) {
  return scene.mesh->vertexCount() * (24.0 + 4.0 * scene.influences);
}

/// Takes place once: a run of the triad is the median of many.
void triad(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(theTriad());
  }
  state.counters["bytes_per_second"] = theTriad().bytesPerSecond;
  state.counters["bytes_of_array"] = static_cast<double>(theTriad().bytesOfArray);
  state.counters["last_level_cache"] = static_cast<double>(theTriad().lastLevelCache);
}
BENCHMARK(triad)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

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
  const double seconds = medianSeconds([&] { live.updatePositions(maps[turn ^= 1]); });
  state.counters["of_triad"] = bytesOfPass(scene) / seconds / theTriad().bytesPerSecond;
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
  const auto aVertex = [&](std::size_t bytes) {
    return static_cast<double>(bytes) / scene.mesh->vertexCount();
  };
  state.counters["bytes_of_weights"] = aVertex(live.bytesOfWeights());
  // Single precision: rest positions, positions and normals; and the corners of the triangles.
  state.counters["bytes_on_screen"] =
      aVertex(sizeof(float) * (2 * live.positions().size() + live.normals().size()) +
              sizeof(Index) * live.triangleSlots().size());
}
BENCHMARK(fullPassWithNormals)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One control point after the other moves, all others being moved; range(0): whether normals are taken too.
/// Counted beside it: how many times longer all take in this run.
void dragOnePoint(benchmark::State& state) {
  Scene& scene = theScene();
  LiveDeformation live(scene.mesh, sharedWeights(scene));
  LevelMaps maps = movedMaps(scene, false, 0.1);
  live.update(maps);
  const double step = 0.001 * scene.mesh->diagonal();
  std::size_t j = 0;
  for (auto _ : state) {
    maps.points[j].col(3).x() += step;
    benchmark::DoNotOptimize(state.range(0) != 0 ? live.update(maps) : live.updatePositions(maps));
    j = (j + 1) % maps.points.size();
  }
  if (state.range(0) == 0) {
    const double one = medianSeconds([&] { maps.points[j = (j + 1) % maps.points.size()].col(3).x() += step; },
                                     [&] { live.updatePositions(maps); });
    state.counters["times_faster"] = fullPassSeconds(scene, false) / one;
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
