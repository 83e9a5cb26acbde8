#pragma once

#include "ui/controllers/transform_gesture.h"
#include "ui/controllers/transform_options.h"

#include <optional>

namespace pbffd::ui {

class Document;

/// The selected points of the edit level that are not locked, their pivot and axes. `viewAxes`: columns
/// right, up, backward of the camera. None when there are no such points.
std::optional<GestureSubject> selectedSubject(const Document& document, const TransformOptions& options,
                                              const Mat3& viewAxes);

/// The median of each coordinate, as edits without a pivot take it. `points` is not empty.
Vec3 medianOf(const std::vector<Vec3>& points);

/// The rotation nearest to a frame's axes, their lengths and shear left aside.
Mat3 directionsOf(const Mat3& axes);

}  // namespace pbffd::ui
