#pragma once

#include "core/project/edit.h"

#include <string>
#include <vector>

// What the functions that apply one kind of edit share. Private to this folder.

namespace pbffd {

/// The greatest identifier that JSON carries in every program that reads it.
constexpr PointId greatestPointId = (PointId{1} << 53) - 1;

/// What an edit is applied to, and with.
struct EditScope {
  const Project& before;
  EditWorkspace& workspace;
  const Progress& progress;
  std::vector<std::string>& remarks;
};

/// The place in ControlSet::levels of a level as edits count them. Throws InvalidInput.
Index placeOfLevel(const ControlSet& set, const std::optional<int>& level);

/// The place of one point on its level. Throws InvalidInput that names the level on which it is instead.
Index placeOfPoint(const ControlSet& set, Index level, PointId id);

/// The level and the places of the points, in the order given. Throws InvalidInput for none, one that is not
/// there, one that is named twice.
struct SelectedPlaces {
  Index level = 0;
  std::vector<Index> places;
};
SelectedPlaces selectedPlaces(const ControlSet& set, const PointSelection& where);

/// A number of levels, each with half as many points as the next, that so many of the finest allow.
void requireLevelCount(int count, Index finestPoints);
void requireFinite(const Vec3& vector, const char* what);
void requireFinite(double number, const char* what);
/// A rest frame: finite, axes with lengths, orthogonal to 1e-9.
void requireRest(const Frame& frame);
/// A pose: finite, axes that can be inverted.
void requirePose(const Frame& frame);
/// A strength: above 0, and such that sums of strengths and their inverses stay finite.
void requireStrength(double strength);

/// Gives the point another rest frame and keeps its transform: pose := M x new rest, to the bit where it is at
/// rest. Its place in the coarser level moves along.
void setRest(ControlPoint& point, const Frame& rest);

/// The project after poses of `level` (and perhaps the master's) were edited: finer levels are carried along,
/// the level hangs anew on the coarser ones, which stay. Throws InvalidInput where that makes a pose that
/// cannot be inverted.
Project withPoses(const EditScope& scope, ControlSet edited, Index level);

/// The project after points, regions or anything else that weights depend on was edited: all poses stay as
/// they are in `edited`, and each level hangs anew on the next coarser one.
Project withStructure(const EditScope& scope, ControlSet edited);

/// The project with other controls of which nothing follows (names, locks).
Project withControls(const EditScope& scope, ControlSet edited);

/// The maps that the present deformation has at places of the rest shape, by the finest level: what a point
/// made there takes for its own. Throws InvalidInput where it cannot be inverted.
std::vector<AffineMap> blendedMapsAt(const EditScope& scope, const ControlSet& set, const Points& places);

}  // namespace pbffd
