#pragma once

#include "core/project/edit_scope.h"

// One function for each kind of edit; private to this folder. Each gives the project after it, or throws
// InvalidInput.

namespace pbffd {

Project applied(const EditScope& scope, const Place& edit);
Project applied(const EditScope& scope, const Move& edit);
Project applied(const EditScope& scope, const Transform& edit);
Project applied(const EditScope& scope, const SetPose& edit);
Project applied(const EditScope& scope, const SetRegion& edit);
Project applied(const EditScope& scope, const Add& edit);
Project applied(const EditScope& scope, const Remove& edit);
Project applied(const EditScope& scope, const Enable& edit);
Project applied(const EditScope& scope, const Lock& edit);
Project applied(const EditScope& scope, const Strength& edit);
Project applied(const EditScope& scope, const SetReach& edit);
Project applied(const EditScope& scope, const Refine& edit);
Project applied(const EditScope& scope, const Rename& edit);
Project applied(const EditScope& scope, const SetLevels& edit);
Project applied(const EditScope& scope, const SetMaster& edit);
Project applied(const EditScope& scope, const SetKernel& edit);
Project applied(const EditScope& scope, const Reset& edit);
Project applied(const EditScope& scope, const Group& edit);

}  // namespace pbffd
