#include "app/dataset/placed_space.h"

#include <utility>

namespace pbffd {

PlacedSpace::PlacedSpace(SpaceDeformation space, const std::optional<Similarity>& toRest)
    : space_(std::move(space)), isPlaced_(toRest.has_value()), toRest_(toRest.value_or(Similarity{})) {}

Points PlacedSpace::positions(const Eigen::Ref<const Points>& places, const Progress& progress) const {
  if (!isPlaced_) {
    Points moved = space_.positions(places, progress);
    note(places, moved);
    return moved;
  }
  const Points rest = atRest(places);
  Points moved = back(places, rest, space_.positions(rest, progress));
  note(places, moved);
  return moved;
}

SpaceImage PlacedSpace::image(const Eigen::Ref<const Points>& places, const Progress& progress) const {
  if (!isPlaced_) {
    SpaceImage image = space_.image(places, progress);
    note(places, image.positions);
    return image;
  }
  const Points rest = atRest(places);
  SpaceImage image = space_.image(rest, progress);
  image.positions = back(places, rest, image.positions);
  for (Mat3& gradient : image.gradients) {
    gradient = toRest_.rotation.transpose() * gradient * toRest_.rotation;
  }
  note(places, image.positions);
  return image;
}

void PlacedSpace::note(const Eigen::Ref<const Points>& places, const Points& moved) const {
  if (!*hasMoved_ && places != moved) {
    *hasMoved_ = true;
  }
}

// Row by row and not as a product of matrices, whose rounding may depend on how many rows there are.

Points PlacedSpace::atRest(const Eigen::Ref<const Points>& places) const {
  const AffineMap map = toRest_.map();
  Points rest(places.rows(), 3);
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    rest.row(i) = applyMap(map, places.row(i).transpose());
  }
  return rest;
}

Points PlacedSpace::back(const Eigen::Ref<const Points>& places, const Points& rest,
                         const Points& deformed) const {
  const Mat3 linear = toRest_.inverse().leftCols<3>();
  Points result = places;
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    if (deformed.row(i) != rest.row(i)) {
      const Vec3 displacement = (deformed.row(i) - rest.row(i)).transpose();
      result.row(i) += (linear * displacement).transpose();
    }
  }
  return result;
}

}  // namespace pbffd
