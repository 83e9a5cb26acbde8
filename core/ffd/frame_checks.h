#pragma once

#include "core/ffd/control_point.h"

namespace pbffd {

/// Whether all numbers of a frame are finite.
bool isFinite(const Frame& frame);

/// Whether a linear map or the axes of a pose can be inverted to any use: finite, and the least stretch more
/// than 1e-12 of the largest.
bool isInvertible(const Mat3& linear);

/// Whether rest axes are orthogonal to 1e-9 (contract, section 4). The lengths are not looked at.
bool areOrthogonal(const Mat3& axes);

/// Whether each axis has a length that can be divided by.
bool haveLengths(const Mat3& axes);

}  // namespace pbffd
