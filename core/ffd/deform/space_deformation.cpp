#include "core/ffd/deform/space_deformation.h"

#include "core/base/parallel.h"
#include "core/ffd/deform/space_portion.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace pbffd {
namespace {

/// Places are taken in portions of this many, one thread a portion: long enough to find what is near in
/// space, short enough to stay in the cache and to stop quickly.
constexpr std::size_t portionSize = std::size_t{1} << 15;

/// The level with every reach as the rule wants it.
Level withRule(const Level& level, ReachRule rule) {
  Level result = level;
  for (Index j = 0; rule == ReachRule::all && j < level.size(); ++j) {
    if (level[j].reach != Reach::all) {
      ControlPoint point = level[j];
      point.reach = Reach::all;
      result.replace(j, std::move(point));
    }
  }
  return result;
}

SpaceImage imageOf(const PreparedSpace& space, const Eigen::Ref<const Points>& places, bool withGradients,
                   const Progress& progress) {
  const auto count = static_cast<std::size_t>(places.rows());
  SpaceImage image;
  image.positions.resize(places.rows(), 3);
  image.gradients.resize(withGradients ? count : 0);
  const std::size_t portions = (count + portionSize - 1) / portionSize;
  std::atomic<std::size_t> done{0};
  parallelFor(portions, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      progress.throwIfCancelled();
      const std::size_t first = p * portionSize;
      const auto row = static_cast<Eigen::Index>(first);
      const auto rows = static_cast<Eigen::Index>(std::min(portionSize, count - first));
      SpaceImage portion = imageOfPortion(space, places.middleRows(row, rows), withGradients);
      image.positions.middleRows(row, rows) = portion.positions;
      std::move(portion.gradients.begin(), portion.gradients.end(),
                image.gradients.begin() + (withGradients ? row : 0));
      progress.report("Deforming", static_cast<double>(++done) / static_cast<double>(portions));
    }
  });
  return image;
}

}  // namespace

PreparedSpace::PreparedSpace(std::shared_ptr<const RestMesh> rest, const ControlSet& set, ReachRule rule,
                             const Progress& progress)
    : mesh(std::move(rest)),
      level(withRule(set.finest(), rule)),
      values(set.basis, set.master, level),
      cuts(regionCuts(*mesh, level, progress)),
      displacements(set.master, level) {
  if (!std::all_of(cuts.begin(), cuts.end(), [](const RegionCut& cut) { return cut.isWhole(); })) {
    nearest.emplace(*mesh);
  }
}

struct SpaceDeformation::Prepared : PreparedSpace {
  using PreparedSpace::PreparedSpace;
};

SpaceDeformation::SpaceDeformation(std::shared_ptr<const RestMesh> mesh, const ControlSet& set, ReachRule rule,
                                   const Progress& progress)
    : prepared_(std::make_unique<const Prepared>(std::move(mesh), set, rule, progress)) {}
SpaceDeformation::~SpaceDeformation() = default;
SpaceDeformation::SpaceDeformation(SpaceDeformation&&) noexcept = default;
SpaceDeformation& SpaceDeformation::operator=(SpaceDeformation&&) noexcept = default;

bool SpaceDeformation::movesAnything() const {
  return prepared_->displacements.isAnyMoved();
}

Points SpaceDeformation::positions(const Eigen::Ref<const Points>& places, const Progress& progress) const {
  if (!movesAnything()) {
    return places;
  }
  return imageOf(*prepared_, places, false, progress).positions;
}

SpaceImage SpaceDeformation::image(const Eigen::Ref<const Points>& places, const Progress& progress) const {
  if (!movesAnything()) {
    return {places, std::vector<Mat3>(static_cast<std::size_t>(places.rows()), Mat3::Identity())};
  }
  return imageOf(*prepared_, places, true, progress);
}

}  // namespace pbffd
