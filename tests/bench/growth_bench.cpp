#include "core/ffd/placement/placement.h"
#include "tests/bench/scene.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace pbffd::bench {
namespace {

/// Each triangle of a mesh of triangles cut into four at the middles of its edges.
Mesh subdivided(const Mesh& mesh) {
  std::map<std::pair<Index, Index>, Index> middles;
  Mesh finer;
  const auto middle = [&](Index a, Index b) {
    const auto next = mesh.vertexCount() + static_cast<Index>(middles.size());
    return middles.try_emplace(std::minmax(a, b), next).first->second;
  };
  finer.faces.reserve(static_cast<std::size_t>(4 * mesh.faces.size()),
                      static_cast<std::size_t>(12 * mesh.faces.size()));
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto v = mesh.faces[f];
    const Index m[3] = {middle(v[0], v[1]), middle(v[1], v[2]), middle(v[2], v[0])};
    for (int k = 0; k < 3; ++k) {
      const Index corner[3] = {v[k], m[k], m[(k + 2) % 3]};
      finer.faces.add(corner);
    }
    finer.faces.add(m);
  }
  finer.positions.resize(mesh.vertexCount() + static_cast<Index>(middles.size()), 3);
  finer.positions.topRows(mesh.vertexCount()) = mesh.positions;
  for (const auto& [ends, vertex] : middles) {
    finer.positions.row(vertex) = 0.5 * (mesh.positions.row(ends.first) + mesh.positions.row(ends.second));
  }
  return finer;
}

double bytesOfArrays(const Mesh& mesh) {
  return static_cast<double>(sizeof(double)) * mesh.positions.size() +
         static_cast<double>(sizeof(Index)) * (mesh.faces.offsets().size() + mesh.faces.vertices().size());
}

/// A line of Linux's /proc/self/status in bytes; 0 where there is none.
double memoryStatus(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == name) {
      double kibibytes = 0.0;
      status >> kibibytes;
      return 1024.0 * kibibytes;
    }
  }
  return 0.0;
}

void forgetPeak() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

/// Placement with the default options on the scene's mesh, its triangles cut into four range(0) times.
/// peak_of_arrays: the memory that it takes at most, the mesh itself counted, as a multiple of the mesh's
/// positions and faces.
void placeOnFinerMesh(benchmark::State& state) {
  Mesh mesh = growingMesh();
  for (int i = 0; i < state.range(0); ++i) {
    mesh = subdivided(mesh);
  }
  const double arrays = bytesOfArrays(mesh);
  double peak = 0.0;
  for (auto _ : state) {
    state.PauseTiming();
    const auto rest = std::make_shared<const RestMesh>(mesh);
    forgetPeak();
    const double before = memoryStatus("VmRSS:");
    state.ResumeTiming();
    benchmark::DoNotOptimize(placeControlPoints(rest, {}));
    state.PauseTiming();
    peak = std::max(peak, arrays + memoryStatus("VmHWM:") - before);
    state.ResumeTiming();
  }
  state.counters["triangles"] = mesh.faces.size();
  state.counters["peak_of_arrays"] = peak / arrays;
}
BENCHMARK(placeOnFinerMesh)
    ->ArgName("cuts")
    ->DenseRange(0, 2)
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace pbffd::bench
