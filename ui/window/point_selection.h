#pragma once

#include "ui/models/pose_edits.h"

namespace pbffd::ui {

class Document;

/// The selected points as they are shown, and as the history holds them: what an edit starts from.
PointsOfLevel shownSelection(const Document& document);
PointsOfLevel committedSelection(const Document& document);

/// So many decimals that a thousandth of the mesh can be told apart.
int decimalsFor(double diagonal);
/// A step of a length field: 1, 2 or 5 times a power of ten, near a thousandth of the mesh.
double stepFor(double diagonal);

}  // namespace pbffd::ui
