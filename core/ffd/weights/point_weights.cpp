#include "core/base/parallel.h"
#include "core/ffd/weights/parameterization.h"
#include "core/ffd/weights/reach.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace pbffd {
namespace {

/// The order of the blocks and what else of free points is needed to find their control points.
struct FreePoints {
  std::vector<Index> order;
  PointBlocks blocks;
  std::vector<Index> nearestSlot;  ///< one a slot: that of the nearest vertex; empty where no reach asks for it

  explicit FreePoints(const Points& at) : order(orderOf(at)), blocks(at, order) {}

  static std::vector<Index> orderOf(const Points& at) {
    Mesh cloud;
    cloud.positions = at;
    return RestMesh(std::move(cloud)).mortonOrder();
  }

  void findNearest(const RestMesh& mesh) {
    const std::vector<Index> slotOf = inverse(mesh.mortonOrder());
    const NearestPoints& vertices = mesh.nearestVertex();
    nearestSlot.resize(order.size());
    parallelFor(order.size(), 256, [&](std::size_t begin, std::size_t end) {
      for (std::size_t slot = begin; slot < end; ++slot) {
        const auto block = static_cast<Index>(slot / PointBlocks::blockSize);
        const auto k = static_cast<Index>(slot % PointBlocks::blockSize);
        nearestSlot[slot] = slotOf[static_cast<std::size_t>(vertices.nearest(blocks.point(block, k)).index)];
      }
    });
  }

 private:
  static std::vector<Index> inverse(const std::vector<Index>& order) {
    std::vector<Index> slotOf(order.size());
    for (std::size_t slot = 0; slot < order.size(); ++slot) {
      slotOf[static_cast<std::size_t>(order[slot])] = static_cast<Index>(slot);
    }
    return slotOf;
  }
};

/// Those of the members whose nearest vertex counts in the region that the walk was started in.
Membership countedBy(const ReachWalk& walk, const Membership& membership,
                     const std::vector<Index>& nearestSlot) {
  Membership counted;
  for (std::size_t e = 0; e < membership.blocks.size(); ++e) {
    unsigned mask = 0;
    for (unsigned left = membership.members[e]; left != 0; left &= left - 1) {
      const Index slot = membership.blocks[e] * PointBlocks::blockSize + std::countr_zero(left);
      mask |= (left & -left) * static_cast<unsigned>(walk.counts(nearestSlot[static_cast<std::size_t>(slot)]));
    }
    if (mask != 0) {
      counted.blocks.push_back(membership.blocks[e]);
      counted.members.push_back(static_cast<std::uint16_t>(mask));
    }
  }
  return counted;
}

/// Leaves the points that count, point by point of the level, where the reach is `connected`.
void restrictToReach(std::vector<Membership>& memberships, const FreePoints& free, const RestMesh& mesh,
                     const Level& level, const Progress& progress) {
  const PointBlocks vertexBlocks(mesh.positions(), mesh.mortonOrder());
  ReachWalks pool(mesh);
  parallelFor(memberships.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      const ControlPoint& point = level[static_cast<Index>(j)];
      if (point.reach != Reach::connected || memberships[j].blocks.empty()) {
        continue;
      }
      progress.throwIfCancelled();
      const Region region(point.rest);
      const ReachWalks::Loan walk = pool.take();
      walk->start(vertexBlocks, region, pointsInside(vertexBlocks, region));
      memberships[j] = countedBy(*walk, memberships[j], free.nearestSlot);
    }
  });
}

std::vector<Membership> freeMemberships(FreePoints& free, const RestMesh& mesh, const Level& level,
                                        const Progress& progress) {
  std::vector<Membership> memberships(static_cast<std::size_t>(level.size()));
  parallelFor(memberships.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      progress.throwIfCancelled();
      if (const ControlPoint& point = level[static_cast<Index>(j)]; point.enabled) {
        memberships[j] = pointsInside(free.blocks, Region(point.rest));
      }
    }
  });
  const bool walks = std::any_of(level.begin(), level.end(), [](const ControlPoint& point) {
    return point.enabled && point.reach == Reach::connected;
  });
  if (walks && mesh.vertexCount() > 0 && !free.order.empty()) {
    free.findNearest(mesh);
    restrictToReach(memberships, free, mesh, level, progress);
  }
  return memberships;
}

/// Row lengths as a running sum: row i begins at entry i.
std::vector<Index> rowStarts(const BlockLists& lists, const std::vector<Index>& order) {
  std::vector<Index> start(order.size() + 1, 0);
  for (std::size_t b = 0; b + 1 < lists.start.size(); ++b) {
    for (auto e = static_cast<std::size_t>(lists.start[b]); e < static_cast<std::size_t>(lists.start[b + 1]);
         ++e) {
      for (unsigned left = lists.members[e]; left != 0; left &= left - 1) {
        const std::size_t slot = b * PointBlocks::blockSize + static_cast<std::size_t>(std::countr_zero(left));
        ++start[static_cast<std::size_t>(order[slot]) + 1];
      }
    }
  }
  for (std::size_t i = 1; i < start.size(); ++i) {
    start[i] += start[i - 1];
  }
  return start;
}

}  // namespace

PointWeights weightsAt(const Points& at, const RestMesh& mesh, const Basis& basis, const Master& master,
                       const Level& level, const Progress& progress) {
  FreePoints free(at);
  const BlockLists lists = listsOf(freeMemberships(free, mesh, level, progress), free.blocks.blockCount());
  PointWeights result;
  result.start = rowStarts(lists, free.order);
  result.points.resize(static_cast<std::size_t>(result.start.back()));
  result.weights.resize(result.points.size());
  result.master.resize(free.order.size());
  const LevelValues values(basis, master, level);
  parallelFor(static_cast<std::size_t>(free.blocks.blockCount()), 16, [&](std::size_t begin, std::size_t end) {
    BlockValues block(values, free.blocks);
    for (std::size_t b = begin; b < end; ++b) {
      const BlockList list = lists.list(static_cast<Index>(b));
      block.evaluate(static_cast<Index>(b), list);
      const std::size_t first = b * PointBlocks::blockSize;
      for (std::size_t k = 0; k < std::min<std::size_t>(PointBlocks::blockSize, free.order.size() - first);
           ++k) {
        const auto row = static_cast<std::size_t>(free.order[first + k]);
        auto entry = static_cast<std::size_t>(result.start[row]);
        for (std::size_t e = 0; e < list.points.size(); ++e) {
          if ((list.members[e] >> k & 1) != 0) {
            result.points[entry] = list.points[e];
            result.weights[entry++] = block.entries()[e][k] * block.toWeight()[k];
          }
        }
        result.master[row] = block.master()[k] * block.toWeight()[k];
      }
    }
  });
  return result;
}

AffineMap blendedMap(const PointWeights& weights, Index row, const LevelMaps& maps) {
  // Displacement form: unmoved points add nothing, so that the blend of maps at rest is exactly the identity.
  const AffineMap identity = identityMap();
  AffineMap blend = identity;
  const auto add = [&](double weight, const AffineMap& map) {
    if (map != identity) {
      blend += weight * (map - identity);
    }
  };
  const auto at = static_cast<std::size_t>(row);
  for (auto e = static_cast<std::size_t>(weights.start[at]);
       e < static_cast<std::size_t>(weights.start[at + 1]); ++e) {
    add(weights.weights[e], maps.points[static_cast<std::size_t>(weights.points[e])]);
  }
  add(weights.master[at], maps.master);
  return blend;
}

}  // namespace pbffd
