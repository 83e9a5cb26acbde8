#include "core/base/error.h"
#include "core/mesh/io/mesh_io.h"
#include "tests/fuzz/mesh_mutations.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

// Feeds mutated mesh files to the readers and what can be read to the writers. Whatever a file holds, reading
// it ends in a mesh or in an InvalidInput, soon; an unmoved mesh is its file, and a moved one reads back.

namespace pbffd::test {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double longestSeconds = 5.0;

Mesh parsed(const MeshFile& file) {
  return parseMesh(std::make_shared<const std::string>(file.bytes), file.name);
}

/// What is wrong with the mesh of a file; empty when nothing is.
std::string checkShapes(const Mesh& mesh) {
  const MeshFormat own = mesh.source.format;
  if (encodeMesh(mesh, {mesh.positions, {}}, own) != *mesh.source.bytes) {
    return "an unmoved mesh is not its file";
  }
  Mat3 turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const DeformedShape shape{mesh.positions * turn.transpose(),
                            std::vector<Mat3>(static_cast<std::size_t>(mesh.vertexCount()), turn)};
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::off, MeshFormat::ply, MeshFormat::stl}) {
    std::string bytes;
    try {
      bytes = encodeMesh(mesh, shape, format);
    } catch (const InvalidInput&) {
      continue;
    }
    const char* const names[] = {"", "a.obj", "a.off", "a.ply", "a.stl"};
    const Mesh again = parsed({names[static_cast<int>(format)], bytes});
    const bool isExact = format == MeshFormat::obj || format == MeshFormat::off;
    if (isExact && again.positions != shape.positions) {
      return std::string("a moved mesh does not read back from ") + names[static_cast<int>(format)];
    }
  }
  return {};
}

/// What is wrong with reading the file; empty when nothing is.
std::string check(const MeshFile& file, std::size_t& readable) {
  const Clock::time_point start = Clock::now();
  std::string wrong;
  try {
    const Mesh mesh = parsed(file);
    ++readable;
    wrong = checkShapes(mesh);
  } catch (const InvalidInput& error) {
    const std::string message = error.what();
    wrong = message.starts_with("Could not read " + file.name + ". ") ? "" : "an odd message: " + message;
  } catch (const std::exception& error) {
    wrong = std::string("an exception: ") + error.what();
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return wrong.empty() && seconds > longestSeconds ? "it took too long" : wrong;
}

int fuzz(double seconds, std::uint64_t seed) {
  const std::vector<MeshFile> seeds = seedMeshFiles();
  const Clock::time_point start = Clock::now();
  std::size_t files = 0;
  std::size_t readable = 0;
  for (; std::chrono::duration<double>(Clock::now() - start).count() < seconds; ++files) {
    std::mt19937_64 random(seed + files);
    MeshFile file = seeds[random() % seeds.size()];
    file.bytes = mutated(file.bytes, random);
    if (const std::string wrong = check(file, readable); !wrong.empty()) {
      std::fprintf(stderr, "Seed %llu, %s: %s\n%s\n", static_cast<unsigned long long>(seed + files),
                   file.name.c_str(), wrong.c_str(), file.bytes.c_str());
      return 1;
    }
  }
  std::printf("%zu files, of which %zu could be read: nothing wrong\n", files, readable);
  return 0;
}

}  // namespace
}  // namespace pbffd::test

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::strtod(argv[1], nullptr) : 60.0;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  return pbffd::test::fuzz(seconds, seed);
}
