#include "core/ffd/deform/inverse.h"

#include "core/ffd/deform/space_deformation.h"
#include "core/ffd/frame_checks.h"
#include "core/mesh/nearest.h"

#include <Eigen/LU>
#include <algorithm>

namespace pbffd {
namespace {

/// Where the deformation takes a place, and how (d place' / d place).
struct Image {
  Vec3 place;
  Mat3 gradient;
};

Image imageOf(const SpaceDeformation& deformation, const Vec3& place) {
  Points one(1, 3);
  one.row(0) = place;
  const SpaceImage image = deformation.image(one);
  return {image.positions.row(0).transpose(), image.gradients[0]};
}

std::optional<Vec3> newton(const SpaceDeformation& deformation, const Vec3& start, const Vec3& posed,
                           double tolerance) {
  constexpr int iterations = 50;
  constexpr double shortestStep = 1e-4;
  Vec3 place = start;
  Image image = imageOf(deformation, place);
  for (int i = 0; i < iterations; ++i) {
    const double miss = (image.place - posed).norm();
    if (miss <= tolerance) {
      return place;
    }
    if (!isInvertible(image.gradient)) {
      return std::nullopt;
    }
    const Vec3 step = image.gradient.inverse() * (posed - image.place);
    double share = 1.0;
    Image next = imageOf(deformation, place + step);
    while (!((next.place - posed).norm() < miss) && share > shortestStep) {
      share *= 0.5;
      next = imageOf(deformation, place + share * step);
    }
    if (!((next.place - posed).norm() < miss)) {
      return std::nullopt;
    }
    place += share * step;
    image = next;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vec3> restPlaceOf(const Vec3& posed, const std::shared_ptr<const RestMesh>& mesh,
                                const ControlSet& set, const Points& deformed, const Progress& progress) {
  constexpr int starts = 8;
  const SpaceDeformation deformation(mesh, set, ReachRule::asStored, progress);
  // Far from the origin the rounding of the coordinates themselves is larger.
  const double tolerance = std::max(1e-12 * mesh->diagonal(), 4e-16 * posed.cwiseAbs().maxCoeff());
  for (const auto& vertex : NearestPoints(deformed).nearest(posed, starts)) {
    progress.throwIfCancelled();
    const Vec3 start = mesh->positions().row(vertex.index).transpose();
    if (const auto place = newton(deformation, start, posed, tolerance)) {
      return place;
    }
  }
  return std::nullopt;
}

}  // namespace pbffd
