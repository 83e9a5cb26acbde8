// The camera of the viewport: framing, sides, and where things are on the screen.

#include "ui/views/viewport_parts.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace pbffd::ui {
namespace {

/// The share of the view that framing fills.
constexpr double fillAll = 0.80;
constexpr double fillSelection = 0.55;
/// Of a view that is covered nearly whole.
constexpr double leastFill = 0.3;

}  // namespace

void Viewport::setCovered(int left, int top) {
  parts_->coveredLeft = left;
  parts_->coveredTop = top;
}

void Viewport::frameAll() {
  Parts& p = *parts_;
  const SurfaceBuffers& buffers = p.content.surface().buffers();
  if (p.content.surface().mesh() == nullptr) {
    return;
  }
  const Vec3 origin = p.content.origin();
  const auto eachVertex = [&](const std::function<void(const Vec3&)>& see) {
    const std::vector<float>& positions = *buffers.positions;
    for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
      see(origin + Vec3(positions[i], positions[i + 1], positions[i + 2]));
    }
  };
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  eachVertex([&](const Vec3& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  });
  const double aspect = static_cast<double>(std::max(width(), 1)) / std::max(height(), 1);
  const double uncovered = 1.0 - 2.0 * p.coveredTop / std::max(height(), 1);
  p.camera.frame(0.5 * (low + high), eachVertex, aspect, std::clamp(uncovered, leastFill, fillAll));
  setCamera(p.camera);
}

void Viewport::frameSelection() {
  Parts& p = *parts_;
  const Selection& selection = p.document.selection();
  const auto& levels = p.document.shown().controls.levels;
  const Index place = p.document.editLevel();
  std::vector<Vec3> corners;
  if (place >= 0 && place < static_cast<Index>(levels.size())) {
    for (const ControlPoint& point : levels[place]) {
      if (selection.contains(point.id)) {
        for (int axis = 0; axis < 3; ++axis) {
          corners.push_back(point.pose.center + point.pose.axes.col(axis));
          corners.push_back(point.pose.center - point.pose.axes.col(axis));
        }
      }
    }
  }
  if (corners.empty()) {
    frameAll();
    return;
  }
  Vec3 center = Vec3::Zero();
  for (const Vec3& corner : corners) {
    center += corner / static_cast<double>(corners.size());
  }
  const auto eachCorner = [&](const std::function<void(const Vec3&)>& see) {
    std::for_each(corners.begin(), corners.end(), see);
  };
  const double aspect = static_cast<double>(std::max(width(), 1)) / std::max(height(), 1);
  p.camera.frame(center, eachCorner, aspect, fillSelection);
  setCamera(p.camera);
}

void Viewport::lookFrom(Side side) {
  const double quarter = 0.5 * std::numbers::pi;
  Camera& camera = parts_->camera;
  switch (side) {
    case Side::front:
      camera.turnTo(0.0, 0.0);
      break;
    case Side::back:
      camera.turnTo(2.0 * quarter, 0.0);
      break;
    case Side::right:
      camera.turnTo(quarter, 0.0);
      break;
    case Side::left:
      camera.turnTo(-quarter, 0.0);
      break;
    case Side::top:
      camera.turnTo(0.0, quarter);
      break;
    case Side::bottom:
      camera.turnTo(0.0, -quarter);
      break;
  }
  setCamera(camera);
}

const Camera& Viewport::camera() const {
  return parts_->camera;
}

void Viewport::setCamera(const Camera& camera) {
  parts_->camera = camera;
  parts_->triad->setAxes(camera.axes());
  requestFrame();
  Q_EMIT cameraChanged();
}

void Viewport::orbitBy(double yawDegrees, double pitchDegrees) {
  Camera camera = parts_->camera;
  camera.orbit(camera.focus, radians(yawDegrees), radians(pitchDegrees));
  setCamera(camera);
}

Projection Viewport::projection() const {
  return parts_->camera.projection(parts_->widget->width(), parts_->widget->height(), parts_->content.extent());
}

Vec3 Viewport::projected(const Vec3& world) const {
  return projection().toScreen(world);
}

PickRay Viewport::rayThrough(const QPointF& position) const {
  return projection().rayThrough(position.x(), position.y());
}

double Viewport::pixelSizeAt(const Vec3& world) const {
  return projection().pixelSizeAt(world);
}

Vec3 Viewport::viewDirection() const {
  return parts_->camera.forward();
}

Vec3 Viewport::upDirection() const {
  return parts_->camera.up();
}

Vec3 Viewport::rightDirection() const {
  return parts_->camera.right();
}

}  // namespace pbffd::ui
