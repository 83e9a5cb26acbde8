#include "core/project/edit_survivors.h"

#include "core/base/text.h"
#include "core/ffd/rest_centres.h"
#include "core/project/shape.h"

#include <algorithm>

namespace pbffd {

bool survives(const ControlPoint& point) {
  return point.kind == PointKind::manual || point.kind == PointKind::curve || point.locked;
}

void poseByDeformation(const EditScope& scope, const ControlSet& former, ControlSet& made,
                       std::size_t levelCount) {
  if (isAtRest(former)) {
    return;
  }
  for (std::size_t l = 0; l < levelCount; ++l) {
    Level& level = made.levels[l];
    const std::vector<AffineMap> maps = blendedMapsAt(scope, former, restCentres(level));
    for (Index i = 0; i < level.size(); ++i) {
      ControlPoint point = level[i];
      point.pose = moved(point.rest, maps[i]);
      level.replace(i, std::move(point));
    }
  }
}

void addCoarserSurvivors(const EditScope& scope, const ControlSet& former, ControlSet& made, int kept) {
  const auto formerCount = static_cast<int>(former.levels.size());
  const auto madeCount = static_cast<int>(made.levels.size());
  int homeless = 0;
  for (int fromFinest = kept; fromFinest < formerCount; ++fromFinest) {
    const Level& level = former.levels[formerCount - 1 - fromFinest];
    for (Index i = 0; i < level.size(); ++i) {
      if (!survives(level[i])) {
        continue;
      }
      if (madeCount == 1) {
        ++homeless;
        continue;
      }
      // The points built anew stand for all finer ones.
      ControlPoint survivor = level[i];
      survivor.mergedFrom.clear();
      made.levels[std::max(0, madeCount - 1 - fromFinest)].append(std::move(survivor));
    }
  }
  if (homeless > 0) {
    scope.remarks.push_back(
        format("{} point{} that {} made by hand or locked on coarser levels left with them.", homeless,
               homeless == 1 ? "" : "s", homeless == 1 ? "was" : "were"));
  }
}

}  // namespace pbffd
