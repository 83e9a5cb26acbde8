#pragma once

#include "core/project/edit.h"
#include "ui/document/expression.h"

#include <optional>
#include <vector>

namespace pbffd::ui {

// What the inspector's fields mean as edits: pure functions of the selected points.

/// The selected points of a level, in the order of the selection.
struct PointsOfLevel {
  int level = 1;
  std::vector<const ControlPoint*> points;
  bool isWhole = false;  ///< all of the level, none locked: what moves them alike moves the master along
};

/// A value that several points may share.
struct SharedValue {
  double middle = 0.0;  ///< the median
  bool isMixed = false;
};
SharedValue shared(std::vector<double> values);

/// The rotation that a point's pose has against rest, as angles about the global x, y and z axes in this
/// order, in degrees.
Vec3 rotationAngles(const ControlPoint& point);
Mat3 rotationFromAngles(const Vec3& degrees);

/// The median of the posed centres moves to (or by, or each is multiplied by) what was typed.
std::optional<Edit> positionEdit(const PointsOfLevel& selection, int axis, const NumberInput& input);
/// The same for the offset of the posed centres from rest.
std::optional<Edit> offsetEdit(const PointsOfLevel& selection, int axis, const NumberInput& input);
/// Each point turns about its own centre until its angle about `axis` is what was typed.
std::optional<Edit> rotationEdit(const PointsOfLevel& selection, int axis, const NumberInput& input);
/// Semi-axis `axis` of each region; `uniform`: the other two keep their ratio to it.
std::optional<Edit> regionEdit(const PointsOfLevel& selection, int axis, const NumberInput& input,
                               bool uniform);

}  // namespace pbffd::ui
