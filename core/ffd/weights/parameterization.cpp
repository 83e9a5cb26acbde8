#include "core/ffd/weights/parameterization.h"

#include "core/base/parallel.h"
#include "core/ffd/weights/reach.h"

#include <utility>

namespace pbffd {
namespace {

constexpr std::size_t blockGrain = 64;

/// The members of each control point of the level among the vertices; none for those that are disabled.
std::vector<Membership> vertexMemberships(const RestMesh& mesh, const PointBlocks& blocks, const Level& level,
                                          const Progress& progress) {
  const auto count = static_cast<std::size_t>(level.size());
  ReachWalks walks(mesh);
  std::vector<Membership> memberships(count);
  parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) {
      progress.throwIfCancelled();
      if (const ControlPoint& point = level[static_cast<Index>(j)]; point.enabled) {
        memberships[j] = reachedBy(point, blocks, walks);
      }
    }
  });
  return memberships;
}

}  // namespace

Parameterization parameterize(const RestMesh& mesh, const Basis& basis, const Master& master,
                              const Level& level, const Progress& progress) {
  progress.report("Computing weights: regions", 0.0);
  const PointBlocks blocks(mesh.positions(), mesh.mortonOrder());
  BlockLists lists = listsOf(vertexMemberships(mesh, blocks, level, progress), blocks.blockCount());

  progress.report("Computing weights: basis values", 0.5);
  Parameterization result;
  result.vertexCount = mesh.vertexCount();
  result.pointCount = level.size();
  result.blockStart = std::move(lists.start);
  result.points = std::move(lists.points);
  result.members = std::move(lists.members);
  result.weights.resize(result.points.size() * Parameterization::blockSize);
  result.masterMembers.resize(static_cast<std::size_t>(blocks.blockCount()));
  const LevelValues values(basis, master, level);
  parallelFor(static_cast<std::size_t>(blocks.blockCount()), blockGrain,
              [&](std::size_t begin, std::size_t end) {
                progress.throwIfCancelled();
                BlockValues block(values, blocks);
                for (std::size_t b = begin; b < end; ++b) {
                  block.evaluate(static_cast<Index>(b), result.list(static_cast<Index>(b)));
                  float* weights = result.weights.data() +
                                   static_cast<std::size_t>(result.blockStart[b]) * Parameterization::blockSize;
                  blockKernels().weights(block.entries().data()->data(), block.entries().size(),
                                         block.toWeight().data(), weights);
                  unsigned masterMembers = 0;
                  for (unsigned k = 0; k < Parameterization::blockSize; ++k) {
                    masterMembers |= static_cast<unsigned>(block.master()[k] * block.toWeight()[k] > 0.0) << k;
                  }
                  result.masterMembers[b] = static_cast<std::uint16_t>(masterMembers);
                }
              });
  return result;
}

}  // namespace pbffd
