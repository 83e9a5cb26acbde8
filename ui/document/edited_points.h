#pragma once

#include "core/project/edit.h"

#include <optional>
#include <vector>

namespace pbffd::ui {

/// The points that an edit names, and their level, 1 the coarsest.
struct EditedPoints {
  int level = 1;
  std::vector<PointId> points;
};

/// None for edits that name no points (place, kernel, reset). The points of an `add` are those of `after`
/// that `before` does not have.
std::optional<EditedPoints> editedPoints(const Edit& edit, const Project& before, const Project& after);

}  // namespace pbffd::ui
