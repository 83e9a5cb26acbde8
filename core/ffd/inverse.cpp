#include "core/ffd/inverse.h"

#include "core/ffd/basis.h"
#include "core/ffd/frame_checks.h"
#include "core/ffd/parameterization.h"
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

class Deformation {
 public:
  Deformation(const RestMesh& mesh, const ControlSet& set)
      : mesh_(mesh), set_(set), maps_(mapsOf(set, set.finest())) {}

  /// The weights and their gradients are those of the members that weightsAt() names there.
  Image at(const Vec3& place) const {
    Points one(1, 3);
    one.row(0) = place;
    const PointWeights weights = weightsAt(one, mesh_, set_.basis, set_.master, set_.finest());
    Value sum;
    std::vector<Value> values;
    for (const Index member : weights.points) {
      const ControlPoint& point = set_.finest()[member];
      values.push_back(valueAt(place, point.rest, point.strength));
      sum += values.back();
    }
    const Value master = weights.master[0] != 0.0 ? masterAt(place) : Value{};
    sum += master;
    Image image{place, Mat3::Identity()};
    if (!(sum.value > 0.0)) {
      return image;
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
      add(image, place, maps_.points[weights.points[k]], values[k], sum);
    }
    add(image, place, maps_.master, master, sum);
    return image;
  }

 private:
  struct Value {
    double value = 0.0;
    Vec3 gradient = Vec3::Zero();
    Value& operator+=(const Value& other) {
      value += other.value;
      gradient += other.gradient;
      return *this;
    }
  };

  Value valueAt(const Vec3& place, const Frame& rest, double strength) const {
    const Region region(rest);
    const Vec3 u = region.parameter(place);
    const double slope = 2.0 * strength * basisSlope(set_.basis, u.squaredNorm());
    return {strength * basisValue(set_.basis, u.squaredNorm()), slope * region.toLocal.transpose() * u};
  }

  Value masterAt(const Vec3& place) const {
    return set_.master.mode == MasterMode::constant ? Value{set_.master.value, Vec3::Zero()}
                                                    : valueAt(place, set_.master.rest, 1.0);
  }

  /// v + sum_j w_j (M_j - I) v, term by term.
  static void add(Image& image, const Vec3& place, const AffineMap& map, const Value& value, const Value& sum) {
    const double weight = value.value / sum.value;
    const Vec3 weightGradient = (value.gradient - weight * sum.gradient) / sum.value;
    const Vec3 displacement = applyMap(map, place) - place;
    image.place += weight * displacement;
    image.gradient +=
        weight * (map.leftCols<3>() - Mat3::Identity()) + displacement * weightGradient.transpose();
  }

  const RestMesh& mesh_;
  const ControlSet& set_;
  LevelMaps maps_;
};

std::optional<Vec3> newton(const Deformation& deformation, const Vec3& start, const Vec3& posed,
                           double tolerance) {
  constexpr int iterations = 50;
  constexpr double shortestStep = 1e-4;
  Vec3 place = start;
  Image image = deformation.at(place);
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
    Image next = deformation.at(place + step);
    while (!((next.place - posed).norm() < miss) && share > shortestStep) {
      share *= 0.5;
      next = deformation.at(place + share * step);
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

std::optional<Vec3> restPlaceOf(const Vec3& posed, const RestMesh& mesh, const ControlSet& set,
                                const Points& deformed) {
  constexpr int starts = 8;
  const Deformation deformation(mesh, set);
  // Far from the origin the rounding of the coordinates themselves is larger.
  const double tolerance = std::max(1e-12 * mesh.diagonal(), 4e-16 * posed.cwiseAbs().maxCoeff());
  for (const auto& vertex : NearestPoints(deformed).nearest(posed, starts)) {
    const Vec3 start = mesh.positions().row(vertex.index).transpose();
    if (const auto place = newton(deformation, start, posed, tolerance)) {
      return place;
    }
  }
  return std::nullopt;
}

}  // namespace pbffd
