#include "tests/fuzz/mesh_mutations.h"

#include "core/mesh/io/mesh_io.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace pbffd::test {
namespace {

constexpr std::string_view obj =
    "# all of OBJ\nmtllib a.mtl\no a\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv +0 1e0 \\\n -.5\r\n"
    "vt 0 0\nvt 1 0 0\nvn 0 0 1\nvn 1 0 0\ng b\nusemtl c\ns 1\nf 1 2 3\nf -4//1 -3//2 -1//1\n"
    "f 1/1/1 2/2/1 3/2/2 4/1/2\nf 1/1 2/2 3/1\nl 1 2\np 3\ncurv 0 1 1 2\n";
constexpr std::string_view off =
    "STCNOFF # all of OFF\n4 3 6\n0 0 0 0 0 1 255 0 0 0 0\n1 0 0 0 0 1 0 255 0 255 1 0\n1 1 0 1 0 0 0 0 255 1 "
    "1\n"
    "0 1 0.5 0 1 0 1 1 1 0 1\n3 0 1 2\n4 0 1 2 3 0.5 0.5 0.5\n3 2 3 0 7\n";
constexpr std::string_view ply =
    "ply\nformat ascii 1.0\ncomment all of PLY\nobj_info none\nelement vertex 4\nproperty float x\nproperty "
    "double y\n"
    "property int z\nproperty float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nproperty "
    "uchar green\n"
    "property uchar blue\nproperty list uchar short extra\nelement tristrips 1\nproperty list int int "
    "vertex_indices\n"
    "element face 2\nproperty list uchar int vertex_index\nproperty float quality\nproperty list uchar float "
    "texcoord\n"
    "element edge 1\nproperty int a\nend_header\n0 0 0 0 0 1 255 0 0 0\n1 0 0 0 0 1 0 255 0 1 5\n1 1 0 1 0 0 0 "
    "0 255 0\n"
    "0 1 1 0 1 0 1 1 1 0\n8 0 1 2 3 -1 3 2 1\n3 0 1 2 0.5 6 0 0 1 0 1 1\n4 0 1 2 3 1 0\n7\n";
constexpr std::string_view stl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
    "0\nendloop\nendfacet\nendsolid a\n";

/// What comes in place of a piece of a file.
constexpr std::array<std::string_view, 22> words{"nan",
                                                 "-inf",
                                                 "1e999",
                                                 "-1",
                                                 "0",
                                                 "4294967295",
                                                 "2147483648",
                                                 "99999999999999999999",
                                                 "/",
                                                 "//1",
                                                 "\\\n",
                                                 "\n",
                                                 "\r",
                                                 " ",
                                                 "#",
                                                 "1.5",
                                                 "end_header\n",
                                                 "f 1 2 3\n",
                                                 "v 1 2 3\n",
                                                 "BINARY",
                                                 "-1e308",
                                                 "3000000000"};

std::size_t below(std::size_t limit, std::mt19937_64& random) {
  return limit == 0 ? 0 : random() % limit;
}

void mutateOnce(std::string& bytes, std::mt19937_64& random) {
  const std::size_t at = below(bytes.size(), random);
  const std::size_t length = std::min(bytes.size() - at, 1 + below(16, random));
  switch (below(7, random)) {
    case 0:
      if (!bytes.empty()) {
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8, random)));
      }
      break;
    case 1:
      bytes.erase(at, length);
      break;
    case 2:
      bytes.insert(below(bytes.size(), random), bytes.substr(at, length));
      break;
    case 3:
      bytes.insert(at, words[below(words.size(), random)]);
      break;
    case 4:
      bytes.replace(at, length, words[below(words.size(), random)]);
      break;
    case 5:
      for (std::size_t i = at; i < at + std::min<std::size_t>(length, 4); ++i) {
        bytes[i] = static_cast<char>(random());
      }
      break;
    default:
      if (below(4, random) == 0) {
        bytes.resize(at);
      }
  }
}

}  // namespace

std::vector<MeshFile> seedMeshFiles() {
  std::vector<MeshFile> files{{"a.obj", std::string(obj)},
                              {"a.off", std::string(off)},
                              {"a.ply", std::string(ply)},
                              {"a.stl", std::string(stl)}};
  const std::size_t texts = files.size();
  for (std::size_t i = 0; i < texts; ++i) {
    // Binary PLY and STL of the text files.
    const Mesh mesh = parseMesh(std::make_shared<const std::string>(files[i].bytes), files[i].name);
    for (const std::string name : {"a.ply", "a.stl"}) {
      if (mesh.source.name != name) {
        files.push_back({name, encodeMesh(mesh, {mesh.positions, {}}, formatOfEnding(name))});
      }
    }
  }
  return files;
}

std::string mutated(std::string bytes, std::mt19937_64& random) {
  for (std::size_t edits = 1 + below(6, random); edits > 0; --edits) {
    mutateOnce(bytes, random);
  }
  return bytes;
}

}  // namespace pbffd::test
