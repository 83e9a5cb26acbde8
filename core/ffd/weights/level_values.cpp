#include "core/ffd/weights/level_values.h"

#include <algorithm>

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
  const RadialNumbers radial = numbersOf(values_->basis());
  influences_.clear();
  for (std::size_t e = 0; e < list.points.size(); ++e) {
    const Index j = list.points[e];
    influences_.push_back({values_->region(j).numbers(), radial, values_->strength(j), list.members[e]});
  }
  // One at least, so that there is memory to name where the list is empty.
  entries_.resize(std::max({entries_.size(), influences_.size(), std::size_t{1}}));
  Lanes total{};
  blockKernels().memberValues(blocks_->numbers(block), influences_.data(), influences_.size(),
                              entries_.data()->data(), total.data());
  master_ = values_->master(*blocks_, block);
  for (std::size_t k = 0; k < total.size(); ++k) {
    total[k] += master_[k];
  }
  blockKernels().inverses(total.data(), toWeight_.data());
}

}  // namespace pbffd
