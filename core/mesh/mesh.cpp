#include "core/mesh/mesh.h"

namespace pbffd {

void Polygons::add(std::span<const Index> corners) {
  vertices_.insert(vertices_.end(), corners.begin(), corners.end());
  offsets_.push_back(static_cast<Index>(vertices_.size()));
}

void Polygons::reserve(std::size_t faces, std::size_t corners) {
  offsets_.reserve(faces + 1);
  vertices_.reserve(corners);
}

Bounds boundsOf(const Points& points) {
  if (points.rows() == 0) {
    return {};
  }
  return {points.colwise().minCoeff().transpose(), points.colwise().maxCoeff().transpose()};
}

}  // namespace pbffd
