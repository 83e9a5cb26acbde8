#include "core/ffd/deform/displacement.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>

namespace pbffd {

Displacement::Displacement(const Frame& rest, const Frame& pose)
    : center(rest.center),
      linear(mapBetween(rest, pose).leftCols<3>() - Mat3::Identity()),
      shift(pose.center - rest.center) {}

LevelDisplacements::LevelDisplacements(const Master& itsMaster, const Level& level)
    : master(itsMaster.rest, itsMaster.pose), isMasterMoved(!(itsMaster.rest == itsMaster.pose)) {
  points.reserve(static_cast<std::size_t>(level.size()));
  isMoved.reserve(static_cast<std::size_t>(level.size()));
  for (const ControlPoint& point : level) {
    points.emplace_back(point.rest, point.pose);
    isMoved.push_back(point.enabled && !(point.rest == point.pose));
  }
}

bool LevelDisplacements::isAnyMoved() const {
  return isMasterMoved || std::find(isMoved.begin(), isMoved.end(), 1) != isMoved.end();
}

bool LevelDisplacements::touches(const BlockList& list) const {
  return isMasterMoved || std::any_of(list.points.begin(), list.points.end(),
                                      [&](Index j) { return isMoved[static_cast<std::size_t>(j)] != 0; });
}

void requireFitting(const Parameterization& weights, const RestMesh& mesh, const Level& level) {
  if (weights.vertexCount != mesh.vertexCount() || weights.pointCount != level.size()) {
    throw InvalidInput(format(
        "The mesh cannot be deformed: its weights are of {} vertices and {} control points, but there are "
        "{} and {}. Compute the weights anew.",
        weights.vertexCount, weights.pointCount, mesh.vertexCount(), level.size()));
  }
}

}  // namespace pbffd
