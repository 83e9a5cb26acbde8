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
  const double openArea = parts.areaOf(false);
  const double closedArea = parts.areaOf(true);
  Shares shares;
  if (parts.countOf(false) > 0) {
    const double share = openArea + closedArea > 0.0 ? openArea / (openArea + closedArea) : 1.0;
    const Index least = std::min(parts.countOf(false), total);
    const Index most = std::max<Index>(least, total - parts.countOf(true));
    shares.around = parts.countOf(true) == 0 ? total : std::clamp(rounded(share * total), least, most);
  }
  shares.exterior = rounded(options.exteriorShare * (total - shares.around));
  shares.interior = total - shares.around - shares.exterior;
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
