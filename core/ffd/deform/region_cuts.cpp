#include "core/ffd/deform/region_cuts.h"

#include "core/base/parallel.h"
#include "core/ffd/weights/membership.h"
#include "core/ffd/weights/reach.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace pbffd {
namespace {

/// The vertices of a region, with their |u|^2.
struct Inside {
  std::vector<Index> vertices;
  std::vector<double> uSquared;

  /// The one that the walk starts from: of least |u|, the lowest on a tie.
  Index nearest() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      if (uSquared[i] < uSquared[best] || (uSquared[i] == uSquared[best] && vertices[i] < vertices[best])) {
        best = i;
      }
    }
    return vertices[best];
  }
};

Inside insideOf(const Region& region, const PointBlocks& blocks, const std::vector<Index>& order) {
  Inside inside;
  const Membership membership = pointsInside(blocks, region);
  for (std::size_t e = 0; e < membership.blocks.size(); ++e) {
    const Lanes squared = blocks.squaredDistances(membership.blocks[e], region);
    for (unsigned left = membership.members[e]; left != 0; left &= left - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(left));
      const auto first = static_cast<std::size_t>(membership.blocks[e]) * PointBlocks::blockSize;
      inside.vertices.push_back(order[first + k]);
      inside.uSquared.push_back(squared[k]);
    }
  }
  return inside;
}

RegionCut cutOf(const Inside& inside, const SurfaceGraph& graph, ReachWalk& walk) {
  if (inside.vertices.empty()) {
    return {};
  }
  walk.start(inside.vertices, inside.uSquared);
  std::vector<Index> cut;
  for (const Index vertex : inside.vertices) {
    if (!walk.counts(vertex)) {
      cut.push_back(graph.representative(vertex));
    }
  }
  std::sort(cut.begin(), cut.end());
  cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
  return {graph.component(inside.nearest()), std::move(cut)};
}

}  // namespace

bool RegionCut::counts(Index vertex, const RestMesh& mesh, const Region& region) const {
  if (isWhole() || mesh.graph().component(vertex) != component_) {
    return true;
  }
  return region.squaredDistance(mesh.positions().row(vertex)) < 1.0 &&
         !std::binary_search(cut_.begin(), cut_.end(), mesh.graph().representative(vertex));
}

std::vector<RegionCut> regionCuts(const RestMesh& mesh, const Level& level, const Progress& progress) {
  const auto isAsked = [](const ControlPoint& point) {
    return point.enabled && point.reach == Reach::connected;
  };
  std::vector<RegionCut> cuts(static_cast<std::size_t>(level.size()));
  if (mesh.vertexCount() == 0 || std::none_of(level.begin(), level.end(), isAsked)) {
    return cuts;
  }
  const std::vector<Index>& order = mesh.mortonOrder();
  const PointBlocks blocks(mesh.positions(), order);
  ReachWalks walks(mesh.graph(), mesh.vertexCount());
  parallelFor(cuts.size(), 1, [&](std::size_t begin, std::size_t end) {
    const ReachWalks::Loan walk = walks.take();
    for (std::size_t j = begin; j < end; ++j) {
      progress.throwIfCancelled();
      if (const ControlPoint& point = level[static_cast<Index>(j)]; isAsked(point)) {
        cuts[j] = cutOf(insideOf(Region(point.rest), blocks, order), mesh.graph(), *walk);
      }
    }
  });
  return cuts;
}

}  // namespace pbffd
