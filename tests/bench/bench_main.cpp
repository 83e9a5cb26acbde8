#include "tests/bench/scene.h"

#include <benchmark/benchmark.h>

#include <exception>
#include <iostream>
#include <string>

// bench_ffd [MESH] [--benchmark_...]: a mesh file of one's own in place of the sphere of a million vertices.
int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc > 2) {
    std::cerr << "bench_ffd takes one mesh file at most.\n";
    return 2;
  }
  if (argc == 2) {
    pbffd::bench::useMesh(argv[1]);
  }
  try {
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
