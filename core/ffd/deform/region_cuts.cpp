#include "core/ffd/deform/region_cuts.h"

#include "core/base/parallel.h"
#include "core/ffd/weights/reach.h"

#include <algorithm>
#include <bit>

namespace pbffd {
namespace {

/// The representatives of those vertices of the region that do not count.
std::vector<Index> cutBy(const ReachWalk& walk, const Membership& inside, const RestMesh& mesh) {
  const std::vector<Index>& order = mesh.mortonOrder();
  std::vector<Index> cut;
  for (std::size_t e = 0; e < inside.blocks.size(); ++e) {
    for (unsigned left = inside.members[e]; left != 0; left &= left - 1) {
      const Index slot = inside.blocks[e] * PointBlocks::blockSize + std::countr_zero(left);
      if (!walk.counts(slot)) {
        cut.push_back(mesh.graph().representative(order[static_cast<std::size_t>(slot)]));
      }
    }
  }
  std::sort(cut.begin(), cut.end());
  cut.erase(std::unique(cut.begin(), cut.end()), cut.end());
  return cut;
}

RegionCut cutOf(const Region& region, const PointBlocks& blocks, const RestMesh& mesh, ReachWalk& walk) {
  const Membership inside = pointsInside(blocks, region);
  if (inside.blocks.empty()) {
    return {};
  }
  walk.start(blocks, region, inside);
  return {walk.component(), cutBy(walk, inside, mesh)};
}

}  // namespace

bool RegionCut::counts(Index vertex, const RestMesh& mesh, const Region& region) const {
  if (isWhole()) {
    return true;
  }
  const SurfaceGraph& graph = mesh.graph();
  if (graph.component(vertex) != component_) {
    return true;
  }
  return region.squaredDistance(mesh.positions().row(vertex)) < 1.0 &&
         !std::binary_search(cut_.begin(), cut_.end(), graph.representative(vertex));
}

std::vector<RegionCut> regionCuts(const RestMesh& mesh, const Level& level, const Progress& progress) {
  const auto isAsked = [](const ControlPoint& point) {
    return point.enabled && point.reach == Reach::connected;
  };
  std::vector<RegionCut> cuts(static_cast<std::size_t>(level.size()));
  if (mesh.vertexCount() == 0 || std::none_of(level.begin(), level.end(), isAsked)) {
    return cuts;
  }
  const PointBlocks blocks(mesh.positions(), mesh.mortonOrder());
  ReachWalks walks(mesh);
  parallelFor(cuts.size(), 1, [&](std::size_t begin, std::size_t end) {
    const ReachWalks::Loan walk = walks.take();
    for (std::size_t j = begin; j < end; ++j) {
      progress.throwIfCancelled();
      if (const ControlPoint& point = level[static_cast<Index>(j)]; isAsked(point)) {
        cuts[j] = cutOf(Region(point.rest), blocks, mesh, *walk);
      }
    }
  });
  return cuts;
}

}  // namespace pbffd
