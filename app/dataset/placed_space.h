#pragma once

#include "core/ffd/deform/space_deformation.h"
#include "core/mesh/alignment.h"

#include <atomic>
#include <memory>
#include <optional>

namespace pbffd {

/// A deformation as another data set sees it, which lies elsewhere in space, in another size or turn: each
/// place is taken to the rest mesh, deformed there and taken back.
class PlacedSpace {
 public:
  explicit PlacedSpace(SpaceDeformation space, const std::optional<Similarity>& toRest = {});

  bool movesAnything() const { return space_.movesAnything(); }

  /// Whether any place was taken elsewhere so far.
  bool hasMoved() const { return *hasMoved_; }

  /// As SpaceDeformation, in the data set's own coordinates; a place that does not move keeps its very bits.
  Points positions(const Eigen::Ref<const Points>& places, const Progress& progress = {}) const;
  SpaceImage image(const Eigen::Ref<const Points>& places, const Progress& progress = {}) const;

 private:
  void note(const Eigen::Ref<const Points>& places, const Points& moved) const;
  Points atRest(const Eigen::Ref<const Points>& places) const;
  Points back(const Eigen::Ref<const Points>& places, const Points& rest, const Points& deformed) const;

  SpaceDeformation space_;
  std::shared_ptr<std::atomic<bool>> hasMoved_ = std::make_shared<std::atomic<bool>>(false);
  bool isPlaced_;
  Similarity toRest_;
};

}  // namespace pbffd
