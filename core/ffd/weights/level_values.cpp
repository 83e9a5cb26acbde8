#include "core/ffd/weights/level_values.h"

#include <algorithm>

namespace pbffd {

LevelValues::LevelValues(const Basis& basis, const Master& master, const Level& level)
    : basis_(basis),
      hasMasterRegion_(master.mode == MasterMode::paper),
      masterValue_(master.value),
      masterRegion_(master.rest) {
  regions_.reserve(static_cast<std::size_t>(level.size()));
  numbers_.reserve(static_cast<std::size_t>(level.size()));
  for (const ControlPoint& point : level) {
    regions_.emplace_back(point.rest);
    numbers_.push_back({regions_.back().numbers(), numbersOf(basis), point.strength});
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
  count_ = list.points.size();
  entries_.resize(std::max(entries_.size(), count_));
  Lanes total{};
  blockKernels().memberValues(blocks_->numbers(block), values_->numbers(), list.points.data(),
                              list.members.data(), count_, entries_.data()->data(), total.data());
  master_ = values_->master(*blocks_, block);
  for (std::size_t k = 0; k < total.size(); ++k) {
    total[k] += master_[k];
  }
  blockKernels().inverses(total.data(), toWeight_.data());
}

}  // namespace pbffd
