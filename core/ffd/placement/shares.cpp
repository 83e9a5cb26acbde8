#include "core/ffd/placement/shares.h"

#include <algorithm>
#include <cmath>

namespace pbffd {
namespace {

Index rounded(double value) {
  return static_cast<Index>(std::lround(value));
}

}  // namespace

Shares wantedShares(const PlacementOptions& options, const SurfaceParts& parts) {
  const Index total = options.points;
  const Index closedParts = parts.countOf(true);
  const Index spare = std::max<Index>(0, total - parts.count());
  const double openArea = parts.areaOf(false);
  const double closedArea = parts.areaOf(true);
  Shares shares;
  if (parts.countOf(false) > 0) {
    // One for each part, and the rest by area.
    const double share = openArea + closedArea > 0.0 ? openArea / (openArea + closedArea) : 1.0;
    const Index each = std::min(parts.countOf(false), total);
    shares.around = closedParts == 0 ? total : each + rounded(share * spare);
  }
  const Index ofClosed = total - shares.around;
  shares.exterior = rounded(options.exteriorShare * ofClosed);
  // Where parts are many, one inside each comes before points outside.
  if (options.exteriorShare < 1.0 && ofClosed >= closedParts && ofClosed - shares.exterior < closedParts) {
    shares.exterior = rounded(options.exteriorShare * (ofClosed - closedParts));
  }
  shares.interior = ofClosed - shares.exterior;
  return shares;
}

Shares fittedShares(const Shares& wanted, Index interiorRoom, Index exteriorRoom, Index aroundRoom) {
  Shares shares{std::min(wanted.interior, interiorRoom), std::min(wanted.exterior, exteriorRoom),
                std::min(wanted.around, aroundRoom)};
  Index missing = wanted.interior + wanted.exterior + wanted.around;
  missing -= shares.interior + shares.exterior + shares.around;
  const auto giveTo = [&](Index& share, Index room) {
    const Index more = std::min(missing, room - share);
    share += more;
    missing -= more;
  };
  giveTo(shares.exterior, exteriorRoom);
  giveTo(shares.interior, interiorRoom);
  giveTo(shares.around, aroundRoom);
  return shares;
}

}  // namespace pbffd
