#include "app/yardsticks/brute_force.h"
#include "app/yardsticks/median.h"
#include "tests/bench/scene.h"

#include <benchmark/benchmark.h>

namespace pbffd::bench {
namespace {

void parameterizeAll(benchmark::State& state) {
  Scene& scene = theScene();
  scene.setReach(Reach::all);
  for (auto _ : state) {
    benchmark::DoNotOptimize(scene.weights());
  }
  state.counters["influences"] = scene.influences;
}
BENCHMARK(parameterizeAll)->Unit(benchmark::kMillisecond)->UseRealTime();

void parameterizeConnected(benchmark::State& state) {
  Scene& scene = theScene();
  scene.setReach(Reach::connected);
  for (auto _ : state) {
    benchmark::DoNotOptimize(scene.weights());
  }
}
BENCHMARK(parameterizeConnected)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Counted beside it: how many times longer it takes than parameterize(), by medians of one kind, and by how
/// much the weights of the two differ at most.
void bruteForce(benchmark::State& state, Reach reach) {
  Scene& scene = theScene();
  scene.setReach(reach);
  const ControlSet& set = scene.set;
  const auto run = [&] {
    return reach == Reach::all ? weightsByBruteForce(*scene.mesh, set.basis, set.master, set.finest())
                               : weightsByWalking(*scene.mesh, set.basis, set.master, set.finest());
  };
  state.counters["difference"] = greatestDifference(run(), scene.weights(), *scene.mesh);
  for (auto _ : state) {
    benchmark::DoNotOptimize(run());
  }
  Parameterization weights;
  const double seconds = medianSeconds([&] { weights = scene.weights(); });
  state.counters["times_longer"] = medianSeconds([&] { run(); }) / seconds;
}
BENCHMARK_CAPTURE(bruteForce, all, Reach::all)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(bruteForce, connected, Reach::connected)->Unit(benchmark::kMillisecond)->UseRealTime();

void weightsOfFreePoints(benchmark::State& state) {
  Scene& scene = theScene();
  scene.setReach(Reach::connected);
  Points at(200, 3);
  for (Index j = 0; j < 200; ++j) {
    at.row(j) = scene.set.finest()[j].rest.center;
  }
  for (auto _ : state) {
    benchmark::DoNotOptimize(weightsAt(at, *scene.mesh, scene.set.basis, scene.set.master, scene.set.finest()));
  }
}
BENCHMARK(weightsOfFreePoints)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace pbffd::bench
