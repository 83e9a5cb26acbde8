#include "core/ffd/weights/level_values.h"

#include <limits>

namespace pbffd {

LevelValues::LevelValues(const Basis& basis, const Master& master, const Level& level)
    : basis_(basis),
      hasMasterRegion_(master.mode == MasterMode::paper),
      masterValue_(master.value),
      masterRegion_(master.rest) {
  regions_.reserve(static_cast<std::size_t>(level.size()));
  strengths_.reserve(static_cast<std::size_t>(level.size()));
  for (const ControlPoint& point : level) {
    regions_.emplace_back(point.rest);
    strengths_.push_back(point.strength);
  }
}

Lanes LevelValues::master(const PointBlocks& blocks, Index block) const {
  if (hasMasterRegion_) {
    return basisValues(basis_, blocks.squaredDistances(block, masterRegion_));
  }
  Lanes constant;
  constant.fill(masterValue_);
  return constant;
}

void BlockValues::evaluate(Index block, const BlockList& list) {
  const BlockKernels& kernels = blockKernels();
  entries_.resize(list.points.size());
  Lanes total{};
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const Index j = list.points[e];
    const InfluenceNumbers influence{values_->region(j).numbers(), numbersOf(values_->basis()),
                                     values_->strength(j), list.members[e]};
    kernels.memberValues(blocks_->numbers(block), influence, entries_[e].data(), total.data());
  }
  master_ = values_->master(*blocks_, block);
  for (std::size_t k = 0; k < total.size(); ++k) {
    total[k] += master_[k];
    // A sum whose inverse is not finite counts as 0.
    toWeight_[k] = total[k] >= std::numeric_limits<double>::min() ? 1.0 / total[k] : 0.0;
  }
}

}  // namespace pbffd
