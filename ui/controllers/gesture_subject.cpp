#include "ui/controllers/gesture_subject.h"

#include "ui/document/document.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <unordered_map>

namespace pbffd::ui {
namespace {

/// As the core takes it: for an even number the mean of the two in the middle.
double median(std::vector<double> values) {
  const std::size_t middle = values.size() / 2;
  std::sort(values.begin(), values.end());
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace

Vec3 medianOf(const std::vector<Vec3>& points) {
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (const Vec3& point : points) {
      values.push_back(point[axis]);
    }
    result[axis] = median(std::move(values));
  }
  return result;
}

Mat3 directionsOf(const Mat3& axes) {
  const Eigen::JacobiSVD<Mat3> svd(axes, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 rotation = svd.matrixU() * svd.matrixV().transpose();
  if (rotation.determinant() < 0.0) {
    rotation.col(2) = -rotation.col(2);
  }
  return rotation;
}

std::optional<GestureSubject> selectedSubject(const Document& document, const TransformOptions& options,
                                              const Mat3& viewAxes) {
  const auto& levels = document.shown().controls.levels;
  const Index place = document.editLevel();
  if (!document.isOpen() || place < 0 || place >= static_cast<Index>(levels.size())) {
    return std::nullopt;
  }
  GestureSubject subject;
  subject.level = static_cast<int>(place) + 1;
  std::vector<Vec3> centers;
  const ControlPoint* active = nullptr;
  const Level& level = levels[static_cast<std::size_t>(place)];
  std::unordered_map<PointId, const ControlPoint*> pointOf;
  pointOf.reserve(static_cast<std::size_t>(level.size()));
  for (const ControlPoint& point : level) {
    pointOf.emplace(point.id, &point);
  }
  for (const PointId id : document.selection().points()) {
    const auto found = pointOf.find(id);
    if (found != pointOf.end() && !found->second->locked) {
      active = found->second;
      subject.points.push_back(id);
      centers.push_back(active->pose.center);
    }
  }
  if (active == nullptr) {
    return std::nullopt;
  }
  subject.isWholeLevel = static_cast<Index>(subject.points.size()) == level.size();
  subject.pivot = options.pivot() == PivotChoice::active ? active->pose.center : medianOf(centers);
  subject.eachItsOwn = options.pivot() == PivotChoice::each;
  subject.localAxes = directionsOf(active->pose.axes);
  subject.size = document.shown().mesh->diagonal();
  if (options.axes() == AxesChoice::local) {
    subject.gizmoAxes = subject.localAxes;
  } else if (options.axes() == AxesChoice::view) {
    subject.gizmoAxes = viewAxes;
  }
  return subject;
}

}  // namespace pbffd::ui
