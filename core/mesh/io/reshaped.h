#pragma once

#include "core/mesh/io/input.h"
#include "core/mesh/io/mesh_io.h"

#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace pbffd::io {

/// Normals that went along with a deformation: row i of `values` belongs to row i of the attribute.
struct TurnedNormals {
  Points values;  ///< each as long as it was
  Points before;  ///< the attribute's

  bool isChanged(Index row, int axis) const {
    return row < values.rows() && values(row, axis) != before(row, axis) && std::isfinite(values(row, axis));
  }
};

/// A mesh and the shape it takes, as those who write it need them. Holds references to both.
class Reshaped {
 public:
  /// Throws InvalidInput where the shape does not fit the mesh or has a number that is not finite.
  Reshaped(const Mesh& mesh, const DeformedShape& shape, const Progress& progress);

  const Mesh& mesh() const { return mesh_; }
  Vec3 position(Index vertex) const { return shape_.positions.row(vertex); }
  const Points& positions() const { return shape_.positions; }

  /// Whether any coordinate has another value than at rest.
  bool isMoved() const { return isMoved_; }
  bool isMoved(Index vertex, int axis) const {
    return shape_.positions(vertex, axis) != mesh_.positions(vertex, axis);
  }
  bool isMoved(Index vertex) const { return isMoved(vertex, 0) || isMoved(vertex, 1) || isMoved(vertex, 2); }

  /// Turns the normals of the vertex or corner domain: each becomes the mean, over the vertices of the
  /// corners that use it, of cofactor(gradient) x normal, as long as before.
  TurnedNormals turned(const Attribute& normals) const;

  /// The source of the mesh, as those who scan it again take it.
  Input source() const;
  /// Throws Cancelled when asked to stop; called every few thousand steps.
  void checkpoint(std::size_t done, std::size_t all) const;
  /// Throws InvalidInput: `what` says why the file cannot be made.
  [[noreturn]] void fail(std::string_view what, std::string_view advice) const;

 private:
  const Mesh& mesh_;
  const DeformedShape& shape_;
  Progress progress_;
  bool isMoved_ = false;
};

}  // namespace pbffd::io
