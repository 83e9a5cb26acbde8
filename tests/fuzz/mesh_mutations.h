#pragma once

#include <random>
#include <string>
#include <vector>

namespace pbffd::test {

/// A mesh file in one of the formats, to begin from.
struct MeshFile {
  std::string name;
  std::string bytes;
};

/// Small files that between them use every part of every format.
std::vector<MeshFile> seedMeshFiles();

/// The bytes after one to six random edits: bits turned, pieces cut out, doubled or swapped for words that
/// readers stumble over, the end cut off.
std::string mutated(std::string bytes, std::mt19937_64& random);

}  // namespace pbffd::test
