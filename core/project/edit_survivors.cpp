#include "core/project/edit_survivors.h"

#include "core/base/figures.h"
#include "core/base/text.h"
#include "core/ffd/rest_centres.h"
#include "core/project/shape.h"

#include <algorithm>
#include <optional>

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

namespace {

/// The place of the merged point with this very region, but for rounding; none where there is none.
std::optional<Index> placeOfTwin(const Level& level, const Frame& rest) {
  const double size = rest.axes.norm();
  for (Index i = 0; i < level.size(); ++i) {
    const Frame& other = level[i].rest;
    const bool isClose =
        (other.center - rest.center).norm() < 1e-9 * size && (other.axes - rest.axes).norm() < 1e-9 * size;
    if (isClose && level[i].kind == PointKind::merged && !level[i].locked) {
      return i;
    }
  }
  return {};
}

/// Who stood for `former` stands for `now`.
void renameMember(Level& coarser, PointId former, PointId now) {
  for (Index i = 0; i < coarser.size(); ++i) {
    const std::vector<PointId>& members = coarser[i].mergedFrom;
    if (std::binary_search(members.begin(), members.end(), former)) {
      ControlPoint point = coarser[i];
      std::replace(point.mergedFrom.begin(), point.mergedFrom.end(), former, now);
      std::sort(point.mergedFrom.begin(), point.mergedFrom.end());
      coarser.replace(i, std::move(point));
    }
  }
}

/// Puts the survivor into a level built anew: in place of the point that was merged to the same region, if
/// there is one; else beside the others, for the points built anew stand for all finer ones.
void settle(ControlPoint survivor, std::vector<Level>& levels, std::size_t place) {
  Level& level = levels[place];
  survivor.mergedFrom.clear();
  const std::optional<Index> twin = placeOfTwin(level, survivor.rest);
  if (!twin) {
    level.append(std::move(survivor));
    return;
  }
  survivor.mergedFrom = level[*twin].mergedFrom;
  if (place > 0) {
    renameMember(levels[place - 1], level[*twin].id, survivor.id);
  }
  level.replace(*twin, std::move(survivor));
}

}  // namespace

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
      settle(level[i], made.levels, static_cast<std::size_t>(std::max(0, madeCount - 1 - fromFinest)));
    }
  }
  if (homeless > 0) {
    scope.remarks.push_back(
        format("{} point{} that {} made by hand or locked on coarser levels left with them.", counted(homeless),
               homeless == 1 ? "" : "s", homeless == 1 ? "was" : "were"));
  }
}

}  // namespace pbffd
