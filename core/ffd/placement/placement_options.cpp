#include "core/base/error.h"
#include "core/base/text.h"
#include "core/ffd/placement/placement.h"
#include "core/mesh/face_vertices.h"

#include <cmath>
#include <string_view>

namespace pbffd {
namespace {

/// lowest and highest are allowed, but for zero where `isOpenAtZero`.
struct Range {
  double lowest;
  double highest;
  bool isOpenAtZero = false;

  bool holds(double value) const {
    return std::isfinite(value) && value >= lowest && value <= highest && !(isOpenAtZero && value == 0.0);
  }
};

void require(std::string_view option, double value, const Range& range, std::string_view allowed) {
  if (!range.holds(value)) {
    throw InvalidInput(format("Control points cannot be placed: {} is {}, which is not allowed. Give {}.",
                              option, value, allowed));
  }
}

}  // namespace

PlacementOptions paperOptions() {
  PlacementOptions options;
  options.basis = {Kernel::gaussian, 3.0};
  options.masterMode = MasterMode::paper;
  options.radiusFactor = 1.5;
  options.offset = 0.1;
  options.reach = Reach::all;
  return options;
}

void requireValid(const PlacementOptions& options) {
  require("the number of points", options.points, {1, 20000}, "a whole number from 1 to 20000");
  require("the number of levels", options.levels, {1, 15}, "a whole number from 1 to 15");
  require("sigma", options.basis.sigma, {0, 100, true}, "a number above 0, up to 100");
  require("the value of the master", options.master, {0, 1e6}, "a number from 0 to 1000000");
  require("the radius factor", options.radiusFactor, {0, 100, true}, "a number above 0, up to 100; 2 is usual");
  require("the offset", options.offset, {0, 10, true},
          "a share of the diagonal above 0, up to 10; 0.05 is usual");
  require("the exterior share", options.exteriorShare, {0, 1}, "a share of the points from 0 to 1");
  require("the number of sites", options.sites.value_or(0), {0, 1e9}, "a whole number above 0, or all");
}

Master makeMaster(const RestMesh& mesh, double value, MasterMode mode) {
  constexpr double margin = 1.2;
  const FacePositions ofFaces(mesh.mesh());
  const Points& surface = mesh.mesh().faces.empty() ? mesh.positions() : ofFaces.points();
  const Vec3 center = boundsOf(surface).center();
  double squared = 0.0;
  for (Eigen::Index v = 0; v < surface.rows(); ++v) {
    squared = std::max(squared, (surface.row(v).transpose() - center).squaredNorm());
  }
  const double radius = squared > 0.0 ? margin * std::sqrt(squared) : 1.0;
  const Frame frame{center, radius * Mat3::Identity()};
  return {value, mode, frame, frame};
}

}  // namespace pbffd
