#include "core/mesh/io/mesh_io.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/mesh/io/formats.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

namespace pbffd {
namespace {

constexpr std::string_view adviceFormat = "Choose a file of one of these formats, or convert it first.";

[[noreturn]] void failUnknownFormat(const std::string& name) {
  throw InvalidInput(
      format("Could not read {}. Its ending is none of .obj, .off, .ply and .stl. {}", name, adviceFormat));
}

Mesh read(MeshFormat meshFormat, const io::Input& input) {
  switch (meshFormat) {
    case MeshFormat::obj:
      return io::readObj(input);
    case MeshFormat::off:
      return io::readOff(input);
    case MeshFormat::ply:
      return io::readPly(input);
    case MeshFormat::stl:
      return io::readStl(input);
    case MeshFormat::none:
      break;
  }
  failUnknownFormat(input.name);
}

std::string rewrite(const io::Reshaped& shape) {
  switch (shape.mesh().source.format) {
    case MeshFormat::obj:
      return io::rewriteObj(shape);
    case MeshFormat::off:
      return io::rewriteOff(shape);
    case MeshFormat::ply:
      return io::rewritePly(shape);
    case MeshFormat::stl:
      return io::rewriteStl(shape);
    case MeshFormat::none:
      break;
  }
  return *shape.mesh().source.bytes;
}

std::string write(const io::Reshaped& shape, MeshFormat meshFormat) {
  switch (meshFormat) {
    case MeshFormat::obj:
      return io::writeObj(shape);
    case MeshFormat::off:
      return io::writeOff(shape);
    case MeshFormat::ply:
      return io::writePly(shape);
    case MeshFormat::stl:
      return io::writeStl(shape);
    case MeshFormat::none:
      break;
  }
  shape.fail("No format is named for the file", "End its name in .obj, .off, .ply or .stl.");
}

/// Whether the face names three different vertices.
bool hasThreeVertices(std::span<const Index> face) {
  const auto second = std::ranges::find_if(face, [&](Index vertex) { return vertex != face[0]; });
  return std::any_of(second, face.end(), [&](Index vertex) { return vertex != face[0] && vertex != *second; });
}

void remarkOnThinFaces(Mesh& mesh) {
  std::size_t count = 0;
  Index first = 0;
  for (Index face = 0; face < mesh.faces.size(); ++face) {
    if (!hasThreeVertices(mesh.faces[face]) && count++ == 0) {
      first = face;
    }
  }
  if (count > 0) {
    mesh.remarks.push_back(format(
        "{} than three different vertices and {} no area; the first is face {}, counted from 1.",
        io::counted(count, "face names fewer", "faces name fewer"), count == 1 ? "has" : "have", first + 1));
  }
}

}  // namespace

MeshFormat formatOfEnding(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  constexpr std::pair<std::string_view, MeshFormat> endings[] = {{".obj", MeshFormat::obj},
                                                                 {".off", MeshFormat::off},
                                                                 {".ply", MeshFormat::ply},
                                                                 {".stl", MeshFormat::stl}};
  for (const auto& [known, meshFormat] : endings) {
    if (ending == known) {
      return meshFormat;
    }
  }
  return MeshFormat::none;
}

Mesh readMesh(const std::filesystem::path& path, const Progress& progress) {
  std::error_code unknown;
  if (formatOfEnding(path) == MeshFormat::none && std::filesystem::is_regular_file(path, unknown)) {
    failUnknownFormat(path.string());
  }
  progress.report("Reading the mesh");
  return parseMesh(std::make_shared<const std::string>(readFile(path)), path.string(), progress);
}

Mesh parseMesh(std::shared_ptr<const std::string> bytes, const std::string& name, const Progress& progress) {
  const MeshFormat meshFormat = formatOfEnding(name);
  const io::Input input{*bytes, name, progress};
  if (bytes->empty() && meshFormat != MeshFormat::none) {
    input.fail("The file is empty", "Export it again.");
  }
  Mesh mesh = read(meshFormat, input);
  if (mesh.vertexCount() == 0) {
    input.fail("It holds no vertices",
               "Make sure that it is a mesh and that its ending is that of its format.");
  }
  remarkOnThinFaces(mesh);
  mesh.source = {std::filesystem::path(name).filename().string(), meshFormat, std::move(bytes)};
  return mesh;
}

std::string encodeMesh(const Mesh& mesh, const DeformedShape& shape, MeshFormat format,
                       const Progress& progress) {
  const io::Reshaped reshaped(mesh, shape, progress);
  if (format == MeshFormat::none || format != mesh.source.format || !mesh.source.bytes) {
    return write(reshaped, format);
  }
  return reshaped.isMoved() ? rewrite(reshaped) : *mesh.source.bytes;
}

}  // namespace pbffd
