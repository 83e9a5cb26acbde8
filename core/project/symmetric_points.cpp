#include "core/project/symmetric_points.h"

#include "core/base/figures.h"
#include "core/base/text.h"
#include "core/project/mirror.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pbffd {
namespace {

/// A point nearer to the plane than this share of its region is its own partner.
constexpr double nearPlane = 0.25;

struct Halves {
  std::vector<ControlPoint> onPlane;
  std::vector<ControlPoint> positive;
  int count() const { return static_cast<int>(onPlane.size() + 2 * positive.size()); }
};

Halves halvesOf(const Level& level, Axis axis, const Vec3& through) {
  const int k = static_cast<int>(axis);
  Halves halves;
  for (ControlPoint point : level) {
    const double height = point.rest.center[k] - through[k];
    if (std::abs(height) <= nearPlane * Region(point.rest).halfSizes()[k]) {
      point.rest.center[k] = through[k];
      halves.onPlane.push_back(std::move(point));
    } else if (height > 0.0) {
      halves.positive.push_back(std::move(point));
    }
  }
  return halves;
}

/// Leaves out points, the last placed first, until no more than `wanted` are left: pairs, and one of the plane
/// where the number is odd.
void cutTo(Halves& halves, int wanted) {
  while (halves.count() > wanted && !halves.positive.empty() &&
         (halves.count() - wanted >= 2 || halves.onPlane.empty())) {
    halves.positive.pop_back();
  }
  while (halves.count() > wanted && !halves.onPlane.empty()) {
    halves.onPlane.pop_back();
  }
}

Level joined(const Halves& halves, Axis axis, const Vec3& through) {
  const AffineMap mirror = reflection(axis, through);
  Level level;
  const auto append = [&](ControlPoint point) {
    point.id = level.size() + 1;
    point.pose = point.rest;
    level.append(std::move(point));
  };
  for (const ControlPoint& point : halves.onPlane) {
    append(point);
  }
  for (const ControlPoint& point : halves.positive) {
    append(point);
    ControlPoint partner = point;
    partner.rest = moved(point.rest, mirror);
    append(std::move(partner));
  }
  return level;
}

}  // namespace

PlacementResult symmetricPlacement(const PlacementOptions& options, Axis axis, const Vec3& through,
                                   const std::function<PlacementResult(const PlacementOptions&)>& placed) {
  constexpr int attempts = 6;
  PlacementOptions asked = options;
  PlacementResult best;
  Halves bestHalves;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    PlacementResult result = placed(asked);
    Halves halves = halvesOf(result.finest, axis, through);
    const int missing = options.points - halves.count();
    const bool isFull = result.finest.size() < asked.points;
    if (attempt == 0 || std::abs(missing) < std::abs(options.points - bestHalves.count()) || missing <= 0) {
      best = std::move(result);
      bestHalves = std::move(halves);
    }
    if (missing <= 0 || isFull) {
      break;
    }
    asked.points += missing + 1;
  }
  cutTo(bestHalves, options.points);
  best.finest = joined(bestHalves, axis, through);
  best.wanted = options.points;
  if (best.finest.size() < options.points) {
    best.remarks.push_back(format("{} of {} points could be placed in pairs.", counted(best.finest.size()),
                                  counted(options.points)));
  }
  return best;
}

}  // namespace pbffd
