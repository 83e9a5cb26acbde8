#include "core/ffd/weights/reach.h"

#include "core/ffd/weights/parameterization.h"

#include <bit>
#include <limits>
#include <utility>

namespace pbffd {
namespace {

static_assert(BlockGraph::blockSize == PointBlocks::blockSize);

/// All vertices joined to `seed` along edges within `isInside`, both by their representatives.
std::vector<bool> joinedInside(const SurfaceGraph& graph, const std::vector<bool>& isInside, Index seed) {
  std::vector<bool> joined(isInside.size(), false);
  std::vector<Index> stack{seed};
  joined[seed] = true;
  while (!stack.empty()) {
    const Index at = stack.back();
    stack.pop_back();
    for (const Index next : graph.neighbours(at)) {
      if (isInside[next] && !joined[next]) {
        joined[next] = true;
        stack.push_back(next);
      }
    }
  }
  return joined;
}

}  // namespace

ReachWalk::ReachWalk(const RestMesh& mesh)
    : mesh_(&mesh),
      graph_(&mesh.blockGraph()),
      order_(&mesh.mortonOrder()),
      states_(static_cast<std::size_t>(graph_->blockCount())) {}

void ReachWalk::start(const PointBlocks& vertices, const Region& region, const Membership& inside) {
  for (const Index block : used_) {
    states_[static_cast<std::size_t>(block)] = {};
  }
  used_ = inside.blocks;
  component_ = -1;
  if (inside.blocks.empty()) {
    return;
  }
  for (std::size_t e = 0; e < inside.blocks.size(); ++e) {
    states_[static_cast<std::size_t>(inside.blocks[e])].inside = inside.members[e];
  }
  const Index seed = nearest(vertices, region, inside);
  component_ = componentOf(seed);
  flood(seed);
}

Index ReachWalk::nearest(const PointBlocks& vertices, const Region& region, const Membership& inside) const {
  double least = std::numeric_limits<double>::infinity();
  Index best = -1;
  for (std::size_t e = 0; e < inside.blocks.size(); ++e) {
    const Lanes squared = vertices.squaredDistances(inside.blocks[e], region);
    for (unsigned left = inside.members[e]; left != 0; left &= left - 1) {
      const int k = std::countr_zero(left);
      const double distance = squared[static_cast<std::size_t>(k)];
      const Index slot = inside.blocks[e] * BlockGraph::blockSize + k;
      const auto vertex = [&](Index at) { return (*order_)[static_cast<std::size_t>(at)]; };
      if (distance < least || (distance == least && vertex(slot) < vertex(best))) {
        least = distance;
        best = slot;
      }
    }
  }
  return best;
}

void ReachWalk::flood(Index slot) {
  add(slot / BlockGraph::blockSize, 1U << (slot % BlockGraph::blockSize));
  while (!open_.empty()) {
    const Index block = open_.back();
    open_.pop_back();
    const std::uint16_t from = spreadInside(block);
    for (const BlockGraph::Link& link : graph_->links(block)) {
      const State& other = states_[static_cast<std::size_t>(link.block)];
      const unsigned wanted = link.to & other.inside & ~other.reached;
      if (wanted != 0 && (link.from & from) != 0) {
        add(link.block, wanted & graph_->joinedAcross(link, from));
      }
    }
  }
}

void ReachWalk::add(Index block, unsigned slots) {
  State& state = states_[static_cast<std::size_t>(block)];
  if (slots != 0 && state.fresh == 0) {
    open_.push_back(block);
  }
  state.fresh |= static_cast<std::uint16_t>(slots);
  state.reached |= static_cast<std::uint16_t>(slots);
}

/// Walks on within the block from its fresh slots; returns all that it has reached so far.
std::uint16_t ReachWalk::spreadInside(Index block) {
  State& state = states_[static_cast<std::size_t>(block)];
  unsigned left = std::exchange(state.fresh, std::uint16_t{0});
  if (state.inside == graph_->all(block) && graph_->isOne(block)) {
    state.reached = state.inside;
    return state.reached;
  }
  unsigned reached = state.reached;
  while (left != 0) {
    const int k = std::countr_zero(left);
    const unsigned more = graph_->joined(block * BlockGraph::blockSize + k) & state.inside & ~reached;
    left = (left & (left - 1)) | more;
    reached |= more;
  }
  state.reached = static_cast<std::uint16_t>(reached);
  return state.reached;
}

Membership ReachWalk::counted(const Membership& membership) const {
  Membership counted;
  const bool isWhole = mesh_->graph().componentCount() == 1;
  for (std::size_t e = 0; e < membership.blocks.size(); ++e) {
    const Index block = membership.blocks[e];
    unsigned members = membership.members[e];
    if (component_ >= 0) {
      const unsigned cut = members & ~unsigned{states_[static_cast<std::size_t>(block)].reached};
      members &= ~cut;
      for (unsigned left = isWhole ? 0 : cut; left != 0; left &= left - 1) {
        const Index slot = block * BlockGraph::blockSize + std::countr_zero(left);
        members |= (left & -left) * static_cast<unsigned>(componentOf(slot) != component_);
      }
    }
    if (members != 0) {
      counted.blocks.push_back(block);
      counted.members.push_back(static_cast<std::uint16_t>(members));
    }
  }
  return counted;
}

ReachWalks::Loan ReachWalks::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      std::unique_ptr<ReachWalk> walk = std::move(idle_.back());
      idle_.pop_back();
      return Loan(walk.release(), GiveBack(this));
    }
  }
  return Loan(new ReachWalk(*mesh_), GiveBack(this));
}

void ReachWalks::giveBack(std::unique_ptr<ReachWalk> walk) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(walk));
}

Membership reachedBy(const ControlPoint& point, const PointBlocks& vertices, ReachWalks& walks) {
  const Region region(point.rest);
  Membership inside = pointsInside(vertices, region);
  if (point.reach == Reach::all || inside.blocks.empty()) {
    return inside;
  }
  const ReachWalks::Loan walk = walks.take();
  walk->start(vertices, region, inside);
  return walk->counted(inside);
}

Reached reachedVertices(const RestMesh& mesh, const ControlPoint& point) {
  const Region region(point.rest);
  const SurfaceGraph& graph = mesh.graph();
  Reached inside;
  std::vector<bool> isInside(static_cast<std::size_t>(mesh.vertexCount()), false);
  std::size_t nearest = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    if (const double squared = region.squaredDistance(mesh.positions().row(v)); squared < 1.0) {
      inside.vertices.push_back(v);
      inside.uSquared.push_back(squared);
      isInside[static_cast<std::size_t>(graph.representative(v))] = true;
      nearest = squared < inside.uSquared[nearest] ? inside.vertices.size() - 1 : nearest;
    }
  }
  if (point.reach == Reach::all || inside.vertices.empty()) {
    return inside;
  }
  const Index seed = graph.representative(inside.vertices[nearest]);
  const std::vector<bool> joined = joinedInside(graph, isInside, seed);
  Reached reached;
  for (std::size_t i = 0; i < inside.vertices.size(); ++i) {
    const Index v = inside.vertices[i];
    if (joined[static_cast<std::size_t>(graph.representative(v))] ||
        graph.component(v) != graph.component(seed)) {
      reached.vertices.push_back(v);
      reached.uSquared.push_back(inside.uSquared[i]);
    }
  }
  return reached;
}

}  // namespace pbffd
