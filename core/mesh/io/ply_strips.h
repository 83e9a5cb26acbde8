#pragma once

#include "core/mesh/mesh.h"

#include <cstddef>
#include <span>

namespace pbffd::io {

/// Turns strips into triangles: each vertex from the third on makes one with the two before it, every other
/// one turned over so that all face the same way. -1 begins anew.
class StripTriangles {
 public:
  /// Adds the triangles of a strip to the faces.
  void add(std::span<const Index> strip, Polygons& faces);

  /// Triangles that name a vertex twice: strips use them to get from one part to the next, and they are no
  /// faces.
  std::size_t joining() const { return joining_; }

 private:
  std::size_t joining_ = 0;
};

}  // namespace pbffd::io
