#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace pbffd {

/// The format that a file's ending stands for, in any case; `none` for an unknown ending.
MeshFormat formatOfEnding(const std::filesystem::path& path);

/// Reads OBJ, OFF, PLY or STL, by the ending. Throws IoError, or InvalidInput that names the file as `path`
/// does and the line (text) or byte (binary), what is wrong there and what to try.
Mesh readMesh(const std::filesystem::path& path, const Progress& progress = {});

/// The same from memory; `name` (with its ending) stands for the file in messages, and without its folder in
/// Mesh::source.
Mesh parseMesh(std::shared_ptr<const std::string> bytes, const std::string& name,
               const Progress& progress = {});

/// Where a deformation took a mesh.
struct DeformedShape {
  Points positions;  ///< N x 3, row i = vertex i
  /// The deformation gradient at each vertex (d position / d rest position), which turns its normals;
  /// empty where none is known: normals are then taken from the deformed faces.
  std::vector<Mat3> gradients;
};

/// The file that `mesh` in its new shape makes in `format`. In the source's own format only the numbers
/// that changed are rewritten (positions; normals by the mean over the corners that use each), every other
/// byte is the source's, and an unmoved mesh comes out byte for byte. In another format what that format
/// can hold is written. Throws InvalidInput for `none` or where the format cannot hold the mesh.
std::string encodeMesh(const Mesh& mesh, const DeformedShape& shape, MeshFormat format,
                       const Progress& progress = {});

}  // namespace pbffd
