#pragma once

#include "core/base/types.h"

#include <cstdint>
#include <vector>

namespace pbffd {

/// Picks points one by one so that none comes too near to another: a Poisson disk set by dart throwing.
class SpacedPicks {
 public:
  /// A candidate keeps the others off within its spacing, those of its own part and side of the surface only.
  struct Candidate {
    Vec3 position;
    Vec3 normal = Vec3::Zero();  ///< zero: of no side
    Index part = 0;
    double spacing = 0.0;
  };

  /// The candidates lie between `low` and `high`; `spacing` is about what most of them have.
  SpacedPicks(const Vec3& low, const Vec3& high, double spacing);

  /// Takes the candidate unless a picked one is nearer than the lesser of the two spacings.
  bool pick(const Candidate& candidate);
  Index size() const { return static_cast<Index>(picks_.size()); }
  /// Of the picks.
  std::vector<Vec3> positions() const;

 private:
  std::int64_t cellAlong(int axis, double coordinate) const;

  Vec3 low_;
  double inverseCell_;
  std::vector<Index> first_;  ///< one a bucket, which some cells share: the last pick there
  std::vector<Index> next_;   ///< one a pick: another of the same bucket, -1 at the end
  std::vector<Candidate> picks_;
};

}  // namespace pbffd
