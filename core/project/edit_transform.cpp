#include "core/base/error.h"
#include "core/base/text.h"
#include "core/ffd/frame_checks.h"
#include "core/project/edit_functions.h"
#include "core/project/edit_spread.h"
#include "core/project/mirror.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace pbffd {
namespace {

void requireUsable(const Transform& edit) {
  if (edit.pivot) {
    requireFinite(*edit.pivot, "the pivot");
  }
  if (!isInvertible(edit.basis)) {
    throw InvalidInput("the axes of \"basis\" are singular: they span no volume");
  }
  requireFinite(edit.scale, "the scale");
  requireFinite(edit.degrees, "the angle");
  requireFinite(edit.rotationAxis, "the rotation's axis");
  if (edit.degrees != 0.0 && !(edit.rotationAxis.stableNorm() > 0.0)) {
    throw InvalidInput("the rotation's axis has no length");
  }
  if ((edit.scale.array() == 0.0).any()) {
    throw InvalidInput("a scale of 0 makes a pose singular");
  }
  const auto isPartial = [](double weight) { return weight != 0.0 && weight != 1.0; };
  const auto& weights = edit.spread.weights;
  if ((edit.scale.array() < 0.0).any() && std::any_of(weights.begin(), weights.end(), isPartial)) {
    throw InvalidInput("a negative scale cannot be shared out by weights");
  }
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// The median of the posed centres, one coordinate after the other.
Vec3 medianCenter(const Level& level, const std::vector<Index>& places) {
  Vec3 result;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> values;
    for (const Index place : places) {
      values.push_back(level[place].pose.center[k]);
    }
    result[k] = median(std::move(values));
  }
  return result;
}

/// The linear part of the edit at a weight, made to keep the planes given: of the rotation stays the turn
/// about a plane's normal, of the scale the part that mirroring does not change.
Mat3 linearPart(const Transform& edit, double weight, const std::vector<Axis>& onPlanes) {
  Mat3 scale = Mat3::Identity();
  if (edit.scale != Vec3::Ones()) {
    Vec3 factors;
    for (int k = 0; k < 3; ++k) {
      factors[k] = weight == 1.0 ? edit.scale[k] : std::pow(edit.scale[k], weight);
    }
    scale = edit.basis * factors.asDiagonal() * edit.basis.inverse();
  }
  Vec3 rotation = Vec3::Zero();
  if (edit.degrees != 0.0) {
    rotation = weight * edit.degrees * std::numbers::pi / 180.0 * edit.rotationAxis.stableNormalized();
  }
  for (const Axis plane : onPlanes) {
    const Mat3 mirror = reflection(plane, Vec3::Zero()).leftCols<3>();
    scale = (0.5 * (scale + mirror * scale * mirror)).eval();
    const double turn = rotation[static_cast<int>(plane)];
    rotation.setZero();
    rotation[static_cast<int>(plane)] = turn;
  }
  const double angle = rotation.norm();
  if (angle == 0.0) {
    return scale;
  }
  return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix() * scale;
}

void turnAbout(Frame& pose, const Mat3& linear, const Vec3& pivot) {
  if (linear == Mat3::Identity()) {
    return;
  }
  pose.center = pivot + linear * (pose.center - pivot);
  pose.axes = linear * pose.axes;
}

void applyTo(ControlPoint& point, const Transform& edit, const Target& target, const Vec3& pivot,
             const Vec3& planes) {
  Mat3 linear = linearPart(edit, target.weight, target.onPlanes);
  Vec3 center = pivot;
  for (const Axis axis : target.onPlanes) {
    center[static_cast<int>(axis)] = planes[static_cast<int>(axis)];
  }
  for (const Axis axis : target.mirrored) {
    const AffineMap mirror = reflection(axis, planes);
    linear = mirror.leftCols<3>() * linear * mirror.leftCols<3>();
    center = applyMap(mirror, center);
  }
  turnAbout(point.pose, linear, edit.eachItsOwn ? Vec3(point.pose.center) : center);
}

}  // namespace

Project applied(const EditScope& scope, const Transform& edit) {
  const ControlSet& before = scope.before.controls;
  const SelectedPlaces selected = selectedPlaces(before, edit.where);
  requireUsable(edit);
  const Vec3 pivot = edit.pivot ? *edit.pivot : medianCenter(before.levels[selected.level], selected.places);
  const Vec3 planes = mirrorCenter(scope.before, edit.spread);
  ControlSet edited = before;
  Level& level = edited.levels[selected.level];
  for (const Target& target : targetsOf(scope, selected, edit.spread)) {
    ControlPoint point = level[target.place];
    applyTo(point, edit, target, pivot, planes);
    level.replace(target.place, std::move(point));
  }
  if (edit.spread.master) {
    // It has no partner: it takes what all planes keep.
    ControlPoint master;
    master.pose = edited.master.pose;
    applyTo(master, edit, {0, 0, 1.0, edit.spread.mirror, {}}, pivot, planes);
    edited.master.pose = master.pose;
  }
  return withPoses(scope, std::move(edited), selected.level);
}

}  // namespace pbffd
