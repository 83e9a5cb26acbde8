#pragma once

#include "ui/controllers/actions.h"

#include <span>

namespace pbffd::ui {

/// What has to be there before an action can be used.
enum class Needs {
  nothing,
  document,
  points,     ///< the edit level has points
  selection,  ///< of control points
  onePoint,   ///< exactly one control point is selected
  undo,
  redo,
  coarser,  ///< a coarser level than the edit level
  finer,
};

/// A row of the table of actions.
struct ActionRow {
  ActionId id;
  const char* menu;
  int group;  ///< of the menu: groups are parted by separators; negative: in a submenu or in no menu
  const char* text;
  const char* keys;  ///< "Ctrl+Z; Ctrl+Y": one or more, the first is shown
  const char* icon;  ///< of resources/icons, or nothing
  Needs needs = Needs::nothing;
  bool isCheckable = false;
};

/// In the order in which the menus show them; one row an ActionId.
std::span<const ActionRow> actionTable();

}  // namespace pbffd::ui
