#include "core/ffd/weights/reach.h"

#include "core/ffd/weights/parameterization.h"

#include <algorithm>
#include <limits>

namespace pbffd {

void ReachWalk::start(const std::vector<Index>& inside, const std::vector<double>& uSquared) {
  component_ = -1;
  if (inside.empty()) {
    return;
  }
  if (stamp_ > std::numeric_limits<std::uint32_t>::max() - 4) {
    std::fill(marks_.begin(), marks_.end(), 0);
    stamp_ = 0;
  }
  stamp_ += 2;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    marks_[static_cast<std::size_t>(graph_->representative(inside[i]))] = stamp_;
    if (uSquared[i] < uSquared[nearest] || (uSquared[i] == uSquared[nearest] && inside[i] < inside[nearest])) {
      nearest = i;
    }
  }
  component_ = graph_->component(inside[nearest]);
  flood(graph_->representative(inside[nearest]));
}

void ReachWalk::flood(Index seed) {
  const std::uint32_t reached = stamp_ + 1;
  marks_[static_cast<std::size_t>(seed)] = reached;
  stack_.push_back(seed);
  while (!stack_.empty()) {
    const Index at = stack_.back();
    stack_.pop_back();
    for (const Index next : graph_->neighbours(at)) {
      std::uint32_t& mark = marks_[static_cast<std::size_t>(next)];
      if (mark == stamp_) {
        mark = reached;
        stack_.push_back(next);
      }
    }
  }
}

ReachWalks::Loan ReachWalks::take() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) {
    return Loan(new ReachWalk(*graph_, vertexCount_), GiveBack(this));
  }
  std::unique_ptr<ReachWalk> walk = std::move(idle_.back());
  idle_.pop_back();
  return Loan(walk.release(), GiveBack(this));
}

void ReachWalks::giveBack(std::unique_ptr<ReachWalk> walk) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(walk));
}

}  // namespace pbffd
