#pragma once

#include "core/ffd/control_set.h"

namespace pbffd {

/// The centres of a level's rest frames: N x 3, row i = point i.
inline Points restCentres(const Level& level) {
  Points centres(level.size(), 3);
  for (Index i = 0; i < level.size(); ++i) {
    centres.row(i) = level[i].rest.center;
  }
  return centres;
}

}  // namespace pbffd
