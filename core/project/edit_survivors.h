#pragma once

#include "core/project/edit_scope.h"

// What `place` and `levels` keep of the points that were there; private to this folder.

namespace pbffd {

/// Whether placing points afresh leaves this one: made by hand, of a curve, or locked.
bool survives(const ControlPoint& point);

/// Gives the points of the first `levelCount` levels of `made` the transforms that the deformation of `former`
/// has at their places. Does nothing where nothing is deformed.
void poseByDeformation(const EditScope& scope, const ControlSet& former, ControlSet& made,
                       std::size_t levelCount);

/// Puts the survivors of the levels of `former`, but the finest `kept` of them, into the levels of `made` as
/// far from the finest, or the coarsest there is. There they stand for no finer point any more, unless a point
/// was merged to the very same region: its place and its members are the survivor's then. Where `made` has a
/// single level they have no place; a remark says so.
void addCoarserSurvivors(const EditScope& scope, const ControlSet& former, ControlSet& made, int kept = 1);

}  // namespace pbffd
