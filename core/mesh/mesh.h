#pragma once

#include "core/base/types.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pbffd {

enum class MeshFormat { none, obj, off, ply, stl };

/// Faces of any size: face f has corners [offsets[f], offsets[f + 1]) of `vertices`.
class Polygons {
 public:
  Index size() const { return static_cast<Index>(offsets_.size()) - 1; }
  bool empty() const { return size() == 0; }
  std::span<const Index> operator[](Index face) const {
    return {vertices_.data() + offsets_[face], vertices_.data() + offsets_[face + 1]};
  }
  void add(std::span<const Index> corners);
  void reserve(std::size_t faces, std::size_t corners);

  /// F + 1 entries, the first 0.
  const std::vector<Index>& offsets() const { return offsets_; }
  /// One vertex a corner, the faces one after the other.
  const std::vector<Index>& vertices() const { return vertices_; }

 private:
  std::vector<Index> offsets_{0};
  std::vector<Index> vertices_;
};

enum class AttributeDomain { vertex, corner, face, file };

/// What a file says about its vertices, corners or faces beside the positions.
struct Attribute {
  std::string name;  ///< as the file calls it: "vt", "vn", "red", "nx"
  AttributeDomain domain = AttributeDomain::vertex;
  Index width = 1;             ///< numbers a row
  std::vector<double> values;  ///< rows x width, row after row
  /// For the corner domain: a row of `values` for each corner of the mesh, -1 where it has none.
  /// Empty for all others, whose row i belongs to element i.
  std::vector<Index> rowOfCorner;
};

/// The bytes that a mesh was read from; export in the same format rewrites positions within them.
struct MeshSource {
  std::string name;  ///< the file's name without its folder
  MeshFormat format = MeshFormat::none;
  std::shared_ptr<const std::string> bytes;
};

/// A polygon mesh as its file gives it: every vertex, every face of any size, every attribute, in file
/// order. Duplicates, isolated vertices and non-manifold parts stay.
struct Mesh {
  Points positions{0, 3};  ///< N x 3, row i = vertex i
  Polygons faces;
  std::vector<Attribute> attributes;
  /// What the reader noticed and the user may want to know, a sentence each.
  std::vector<std::string> remarks;
  MeshSource source;

  Index vertexCount() const { return static_cast<Index>(positions.rows()); }
};

/// Triangles over the vertices of a mesh. Faces that all are triangles are named where they are, with no copy
/// of them, and must then outlive this.
class Triangles {
 public:
  explicit Triangles(const Polygons& faces) : vertices_(faces.vertices()) {}
  Triangles(std::vector<Index> vertices, std::vector<Index> faceOfTriangle)
      : cut_(std::move(vertices)), vertices_(cut_), faceOfTriangle_(std::move(faceOfTriangle)) {}
  Triangles(Triangles&&) noexcept = default;  // a vector that moves keeps its place in memory
  Triangles& operator=(Triangles&&) noexcept = default;
  Triangles(const Triangles&) = delete;
  Triangles& operator=(const Triangles&) = delete;

  Index size() const { return static_cast<Index>(vertices_.size() / 3); }
  /// 3 a triangle.
  std::span<const Index> vertices() const& { return vertices_; }
  std::span<const Index> vertices() const&& = delete;  // would look at what is gone
  Index faceOf(Index triangle) const { return faceOfTriangle_.empty() ? triangle : faceOfTriangle_[triangle]; }

 private:
  std::vector<Index> cut_;
  std::span<const Index> vertices_;
  std::vector<Index> faceOfTriangle_;  ///< none where every face is a triangle
};

/// Each face as a fan from its first corner, or by cutting ears where it is not convex. Faces of fewer than
/// three corners give none.
Triangles triangulate(const Points& positions, const Polygons& faces);

/// An axis-aligned box.
struct Bounds {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
  double diagonal() const { return (high - low).norm(); }
  Vec3 center() const { return 0.5 * (low + high); }
};
/// Of all rows; all zero for no rows.
Bounds boundsOf(const Points& points);

}  // namespace pbffd
