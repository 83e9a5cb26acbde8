#include "ui/models/pose_edits.h"

#include "core/base/figures.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <QCoreApplication>

#include <algorithm>
#include <numbers>

namespace pbffd::ui {
namespace {

constexpr double toRadians = std::numbers::pi / 180.0;

/// The rotation nearest to the linear part of a point's map.
Mat3 rotationOf(const ControlPoint& point) {
  const Mat3 linear = point.map().leftCols<3>();
  const Eigen::JacobiSVD<Mat3> svd(linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 rotation = svd.matrixU() * svd.matrixV().transpose();
  if (rotation.determinant() < 0.0) {
    Mat3 mirrored = svd.matrixU();
    mirrored.col(2) = -mirrored.col(2);
    rotation = mirrored * svd.matrixV().transpose();
  }
  return rotation;
}

std::vector<PointId> idsOf(const PointsOfLevel& selection) {
  std::vector<PointId> ids;
  for (const ControlPoint* point : selection.points) {
    ids.push_back(point->id);
  }
  return ids;
}

/// Moves the points along one axis so that `values` become what was typed.
std::optional<Edit> moveEdit(const PointsOfLevel& selection, int axis, const std::vector<double>& values,
                             const NumberInput& input) {
  if (values.empty()) {
    return std::nullopt;
  }
  Move move{{selection.level, idsOf(selection)}, {}, Follow::frames, {}};
  if (input.kind == NumberInput::Kind::multiply) {
    for (const double value : values) {
      move.by.push_back((input.appliedTo(value) - value) * Vec3::Unit(axis));
    }
  } else {
    const double middle = shared(values).middle;
    move.by.push_back((input.appliedTo(middle) - middle) * Vec3::Unit(axis));
    move.spread.master = selection.isWhole;
  }
  return move;
}

std::optional<Edit> grouped(std::vector<Edit> edits, const char* text) {
  if (edits.empty()) {
    return std::nullopt;
  }
  if (edits.size() == 1) {
    return edits.front();
  }
  const QString count = QString::fromStdString(counted(edits.size()));
  return Group{QCoreApplication::translate("PoseEdits", text).arg(count).toStdString(), std::move(edits)};
}

}  // namespace

SharedValue shared(std::vector<double> values) {
  if (values.empty()) {
    return {};
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double middle = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  const double spread = values.back() - values.front();
  return {middle, spread > 1e-9 * std::max(1.0, std::abs(middle))};
}

Vec3 rotationAngles(const ControlPoint& point) {
  const Mat3 r = rotationOf(point);
  // r = Rz Ry Rx
  const double y = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
  const bool isLocked = std::abs(r(2, 0)) > 1.0 - 1e-12;
  const double x = isLocked ? 0.0 : std::atan2(r(2, 1), r(2, 2));
  const double z = isLocked ? std::atan2(-r(0, 1), r(1, 1)) : std::atan2(r(1, 0), r(0, 0));
  return Vec3(x, y, z) / toRadians;
}

Mat3 rotationFromAngles(const Vec3& degrees) {
  const Vec3 a = degrees * toRadians;
  return (Eigen::AngleAxisd(a.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(a.y(), Vec3::UnitY()) *
          Eigen::AngleAxisd(a.x(), Vec3::UnitX()))
      .toRotationMatrix();
}

std::optional<Edit> positionEdit(const PointsOfLevel& selection, int axis, const NumberInput& input) {
  std::vector<double> values;
  for (const ControlPoint* point : selection.points) {
    values.push_back(point->pose.center[axis]);
  }
  return moveEdit(selection, axis, values, input);
}

std::optional<Edit> offsetEdit(const PointsOfLevel& selection, int axis, const NumberInput& input) {
  std::vector<double> values;
  for (const ControlPoint* point : selection.points) {
    values.push_back(point->pose.center[axis] - point->rest.center[axis]);
  }
  return moveEdit(selection, axis, values, input);
}

std::optional<Edit> rotationEdit(const PointsOfLevel& selection, int axis, const NumberInput& input) {
  std::vector<Edit> edits;
  for (const ControlPoint* point : selection.points) {
    Vec3 angles = rotationAngles(*point);
    const Mat3 before = rotationFromAngles(angles);
    angles[axis] = input.appliedTo(angles[axis]);
    const Eigen::AngleAxisd turn(Mat3(rotationFromAngles(angles) * before.transpose()));
    Transform transform;
    transform.where = {selection.level, {point->id}};
    transform.eachItsOwn = true;
    transform.rotationAxis = turn.axis();
    transform.degrees = turn.angle() / toRadians;
    edits.push_back(transform);
  }
  return grouped(std::move(edits), "Rotate %1 points");
}

std::optional<Edit> regionEdit(const PointsOfLevel& selection, int axis, const NumberInput& input,
                               bool uniform) {
  std::vector<Edit> edits;
  for (const ControlPoint* point : selection.points) {
    Frame rest = point->rest;
    const double before = rest.axes.col(axis).norm();
    const double factor = input.appliedTo(before) / before;
    if (uniform) {
      rest.axes *= factor;
    } else {
      rest.axes.col(axis) *= factor;
    }
    edits.push_back(SetRegion{selection.level, point->id, rest});
  }
  return grouped(std::move(edits), "Edit regions of %1 points");
}

}  // namespace pbffd::ui
