#include "core/project/edit.h"
#include "tests/bench/scene.h"

#include <benchmark/benchmark.h>

#include <memory>

namespace pbffd::bench {
namespace {

/// The slider of the number of points, from its release to the new set of range(0) points with its levels and
/// the weights that the mesh is shown by: the edit that the window applies. What depends on no number, the
/// Voronoi step too, is kept from a placement of a few points less.
void replaceAtCount(benchmark::State& state) {
  const Project project = projectOf(std::make_shared<const RestMesh>(growingMesh()));
  EditWorkspace workspace;
  Place place;
  place.options.points = static_cast<int>(state.range(0)) - 2;
  const Project before = apply(project, place, workspace).project;
  place.options.points += 2;
  for (auto _ : state) {
    const Project after = apply(before, place, workspace).project;
    benchmark::DoNotOptimize(workspace.weights.parameterization(after.mesh, after.controls));
    // Else the next turn would find these weights made.
    state.PauseTiming();
    static_cast<void>(workspace.weights.parameterization(before.mesh, before.controls));
    state.ResumeTiming();
  }
}
BENCHMARK(replaceAtCount)
    ->ArgName("points")
    ->Arg(50)
    ->Arg(100)
    ->Arg(200)
    ->Arg(500)
    ->Arg(1000)
    ->Arg(2000)
    ->Arg(3000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace pbffd::bench
