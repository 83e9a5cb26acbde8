#include "core/base/parallel.h"
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

/// Every vertex against every control point, on the same threads, without keeping anything but sums.
void parameterizeByBruteForce(benchmark::State& state) {
  const Scene& scene = theScene();
  std::vector<Region> regions;
  for (const ControlPoint& point : scene.set.finest()) {
    regions.emplace_back(point.rest);
  }
  std::vector<double> sums(static_cast<std::size_t>(scene.mesh->vertexCount()));
  for (auto _ : state) {
    parallelFor(sums.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v) {
        const Vec3 vertex = scene.mesh->positions().row(static_cast<Eigen::Index>(v));
        double sum = scene.set.master.value;
        for (const Region& region : regions) {
          sum += basisValue(scene.set.basis, region.squaredDistance(vertex));
        }
        sums[v] = sum;
      }
    });
    benchmark::ClobberMemory();
  }
}
BENCHMARK(parameterizeByBruteForce)->Unit(benchmark::kMillisecond)->UseRealTime();

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
