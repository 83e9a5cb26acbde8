#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/ffd/deform/deformation.h"
#include "core/ffd/deform/displacement.h"
#include "core/ffd/deform/live_kernel.h"
#include "core/ffd/deform/slot_mesh.h"
#include "core/ffd/deform/touched_blocks.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <utility>

namespace pbffd {
namespace {

constexpr std::size_t blockGrain = 64;

/// M - 1 about the origin of the live positions.
AffineMap displacementAbout(const Vec3& origin, const AffineMap& map) {
  const AffineMap difference = map - identityMap();
  AffineMap about = difference;
  about.col(3) += difference.leftCols<3>() * origin;
  return about;
}

LiveMap liveMap(const AffineMap& displacement) {
  LiveMap live{};
  for (int row = 0; row < 3; ++row) {
    live.shift[row] = static_cast<float>(displacement(row, 3));
    for (int column = 0; column < 3; ++column) {
      live.linear[3 * row + column] = static_cast<float>(displacement(row, column));
    }
  }
  const bool isTranslation = displacement.leftCols<3>().isZero(0.0);
  live.kind = !isTranslation                    ? LiveMap::affine
              : displacement.col(3).isZero(0.0) ? LiveMap::rest
                                                : LiveMap::translation;
  return live;
}

std::vector<Index> allBlocks(Index count) {
  std::vector<Index> blocks(static_cast<std::size_t>(count));
  std::iota(blocks.begin(), blocks.end(), 0);
  return blocks;
}

}  // namespace

struct LiveDeformation::State {
  std::shared_ptr<const RestMesh> mesh;
  std::shared_ptr<const Parameterization> weights;
  SlotMesh slots;
  TouchedBlocks touched;
  LiveKernel kernel;
  LevelMaps maps;             ///< those that positions stand at
  std::vector<LiveMap> live;  ///< the same for the kernel, the master's taken off
  LiveMap liveMaster{};
  std::vector<float> positions;
  std::vector<float> normals;
  std::array<float, 48> lastPositions{};
  std::vector<Index> withOldNormals;  ///< blocks evaluated since the normals were, ascending

  State(std::shared_ptr<const RestMesh> itsMesh, std::shared_ptr<const Parameterization> itsWeights,
        LiveKernel itsKernel)
      : mesh(std::move(itsMesh)),
        weights(std::move(itsWeights)),
        slots(*mesh),
        touched(*weights),
        kernel(itsKernel),
        positions(3 * static_cast<std::size_t>(slots.slotCount())),
        normals(positions.size()) {
    rest();
  }

  /// Everything at rest, evaluated.
  void rest() {
    maps.points.assign(static_cast<std::size_t>(weights->pointCount), identityMap());
    maps.master = identityMap();
    live.assign(maps.points.size(), liveMap(AffineMap::Zero()));
    liveMaster = liveMap(AffineMap::Zero());
    evaluate(allBlocks(slots.blockCount()));
    turnNormals();
  }

  std::vector<Index> moveTo(const LevelMaps& next);
  void evaluate(const std::vector<Index>& blocks);
  void turnNormals();
  LivePass pass();
};

/// Takes over what changed; returns the blocks that it touches.
std::vector<Index> LiveDeformation::State::moveTo(const LevelMaps& next) {
  const bool isMasterMoved = next.master != maps.master;
  maps.master = next.master;
  const AffineMap master = displacementAbout(slots.origin(), maps.master);
  std::vector<Index> changed;
  for (std::size_t j = 0; j < maps.points.size(); ++j) {
    if (isMasterMoved || next.points[j] != maps.points[j]) {
      maps.points[j] = next.points[j];
      live[j] = liveMap(displacementAbout(slots.origin(), maps.points[j]) - master);
      changed.push_back(static_cast<Index>(j));
    }
  }
  liveMaster = liveMap(master);
  return isMasterMoved ? allBlocks(slots.blockCount()) : touched.by(changed);
}

LivePass LiveDeformation::State::pass() {
  const bool isLastFull = slots.slotCount() % Parameterization::blockSize == 0;
  return {slots.rest(),
          weights->blockStart.data(),
          weights->points.data(),
          weights->members.data(),
          weights->weights.data(),
          weights->masterMembers.data(),
          live.data(),
          liveMaster,
          positions.data(),
          lastPositions.data(),
          isLastFull ? -1 : slots.blockCount() - 1};
}

void LiveDeformation::State::evaluate(const std::vector<Index>& blocks) {
  const LivePass arrays = pass();
  parallelFor(blocks.size(), blockGrain,
              [&](std::size_t begin, std::size_t end) { kernel(arrays, blocks.data() + begin, end - begin); });
  if (!blocks.empty() && blocks.back() == arrays.lastBlock) {
    const std::size_t first = 48 * static_cast<std::size_t>(arrays.lastBlock);
    std::copy_n(lastPositions.begin(), positions.size() - first,
                positions.begin() + static_cast<std::ptrdiff_t>(first));
  }
  const auto all = static_cast<std::size_t>(slots.blockCount());
  if (withOldNormals.empty() || blocks.size() == all) {
    withOldNormals = blocks;
  } else if (withOldNormals.size() < all) {
    std::vector<Index> both;
    std::set_union(withOldNormals.begin(), withOldNormals.end(), blocks.begin(), blocks.end(),
                   std::back_inserter(both));
    withOldNormals = std::move(both);
  }
}

void LiveDeformation::State::turnNormals() {
  if (withOldNormals.empty()) {
    return;
  }
  const bool isAll = withOldNormals.size() == static_cast<std::size_t>(slots.blockCount());
  const std::vector<Index> around = isAll ? std::move(withOldNormals) : slots.blocksAround(withOldNormals);
  withOldNormals.clear();
  parallelFor(around.size(), blockGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      slots.writeNormals(around[i], positions, normals);
    }
  });
}

LiveDeformation::LiveDeformation(std::shared_ptr<const RestMesh> mesh,
                                 std::shared_ptr<const Parameterization> weights)
    : LiveDeformation(std::move(mesh), std::move(weights), bestInstructions()) {}

LiveDeformation::LiveDeformation(std::shared_ptr<const RestMesh> mesh,
                                 std::shared_ptr<const Parameterization> weights, Instructions instructions) {
  const LiveKernel kernel = liveKernel(instructions);
  if (kernel == nullptr) {
    throw InvalidInput(
        "The deformation cannot use the instructions asked for: this processor does not have them. Use those "
        "of "
        "bestInstructions().");
  }
  if (weights->vertexCount != mesh->vertexCount()) {
    throw InvalidInput(format(
        "The mesh cannot be deformed: its weights are of {} vertices, but it has {}. Compute the weights anew.",
        weights->vertexCount, mesh->vertexCount()));
  }
  state_ = std::make_unique<State>(std::move(mesh), std::move(weights), kernel);
}

LiveDeformation::~LiveDeformation() = default;
LiveDeformation::LiveDeformation(LiveDeformation&&) noexcept = default;
LiveDeformation& LiveDeformation::operator=(LiveDeformation&&) noexcept = default;

Index LiveDeformation::update(const LevelMaps& maps) {
  const Index evaluated = updatePositions(maps);
  updateNormals();
  return evaluated;
}

void LiveDeformation::updateNormals() {
  state_->turnNormals();
}

Index LiveDeformation::updatePositions(const LevelMaps& maps) {
  if (maps.points.size() != state_->maps.points.size()) {
    throw InvalidInput(
        format("The mesh cannot be deformed: its weights are of {} control points, but there are {}. "
               "Compute the weights anew.",
               state_->maps.points.size(), maps.points.size()));
  }
  const std::vector<Index> blocks = state_->moveTo(maps);
  if (blocks.empty()) {
    return 0;
  }
  state_->evaluate(blocks);
  const Index full = static_cast<Index>(blocks.size()) * Parameterization::blockSize;
  const Index beyondLast = state_->slots.blockCount() * Parameterization::blockSize - state_->slots.slotCount();
  return blocks.back() + 1 == state_->slots.blockCount() ? full - beyondLast : full;
}

const Vec3& LiveDeformation::origin() const {
  return state_->slots.origin();
}
const std::vector<float>& LiveDeformation::positions() const {
  return state_->positions;
}
const std::vector<float>& LiveDeformation::normals() const {
  return state_->normals;
}
const std::vector<Index>& LiveDeformation::triangleSlots() const {
  return state_->slots.triangleSlots();
}

std::size_t LiveDeformation::bytesOfWeights() const {
  const Parameterization& weights = *state_->weights;
  return sizeof(float) * weights.weights.size() +
         sizeof(Index) * (weights.blockStart.size() + weights.points.size()) +
         sizeof(std::uint16_t) * (weights.members.size() + weights.masterMembers.size()) +
         state_->touched.bytes() + state_->slots.bytesOfLists();
}

}  // namespace pbffd
