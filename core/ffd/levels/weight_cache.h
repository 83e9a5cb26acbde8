#pragma once

#include "core/base/progress.h"
#include "core/ffd/control_set.h"
#include "core/ffd/levels/hierarchy.h"
#include "core/ffd/weights/parameterization.h"

#include <memory>
#include <vector>

namespace pbffd {

/// Remembers the weights of the last few control sets, which follow from the mesh, the rest regions, the
/// basis and the master alone: an edit of poses finds them here. May be called from any thread.
class WeightCache {
 public:
  WeightCache();
  ~WeightCache();
  WeightCache(const WeightCache&) = delete;
  WeightCache& operator=(const WeightCache&) = delete;

  /// The weights of the mesh's vertices over the finest level.
  std::shared_ptr<const Parameterization> parameterization(const std::shared_ptr<const RestMesh>& mesh,
                                                           const ControlSet& set,
                                                           const Progress& progress = {});

  /// The weights by which each level hangs on the next coarser one, as levelBindings() gives them.
  std::shared_ptr<const std::vector<PointWeights>> bindings(const std::shared_ptr<const RestMesh>& mesh,
                                                            const ControlSet& set,
                                                            const Progress& progress = {});

 private:
  struct Entries;
  std::unique_ptr<Entries> entries_;
};

}  // namespace pbffd
