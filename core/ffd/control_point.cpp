#include "core/ffd/control_point.h"

#include "core/ffd/basis.h"

namespace pbffd {

AffineMap mapBetween(const Frame& rest, const Frame& pose) {
  if (pose.axes == rest.axes) {
    // A translation, exactly: at rest the map is the identity to the last bit.
    return makeMap(Mat3::Identity(), pose.center - rest.center);
  }
  const Mat3 linear = pose.axes * inverseOfOrthogonal(rest.axes);
  return makeMap(linear, pose.center - linear * rest.center);
}

Frame moved(const Frame& frame, const AffineMap& map) {
  if (map == identityMap()) {
    return frame;
  }
  return {applyMap(map, frame.center), map.leftCols<3>() * frame.axes};
}

}  // namespace pbffd
