#include "ui/controllers/action_table.h"

namespace pbffd::ui {
namespace {

using enum ActionId;

constexpr ActionRow rows[] = {
    {openMesh, "File", 0, "Open mesh...", "Ctrl+O", "mesh"},
    {openProject, "File", 0, "Open project...", "Ctrl+Shift+O", "folder"},
    {save, "File", 1, "Save", "Ctrl+S", "save", Needs::document},
    {saveAs, "File", 1, "Save as...", "Ctrl+Shift+S", "", Needs::document},
    {exportMesh, "File", 2, "Export mesh...", "Ctrl+E", "export", Needs::document},
    {exportPicture, "File", 2, "Export picture...", "Ctrl+Shift+E", "", Needs::document},
    {runEdits, "File", 3, "Run edits from file...", "", "", Needs::document},
    {saveEdits, "File", 3, "Save steps as edits...", "", "", Needs::undo},
    {applyToOther, "File", 3, "Apply to another mesh...", "", "", Needs::document},
    {closeDocument, "File", 4, "Close", "Ctrl+W", "", Needs::document},
    {quit, "File", 4, "Quit", "Ctrl+Q", ""},

    {undo, "Edit", 0, "Undo", "Ctrl+Z", "undo", Needs::undo},
    {redo, "Edit", 0, "Redo", "Ctrl+Shift+Z; Ctrl+Y", "redo", Needs::redo},
    {rename, "Edit", 1, "Rename", "F2", "rename", Needs::onePoint},
    {removePoints, "Edit", 1, "Delete", "Del", "remove", Needs::selection},
    {find, "Edit", 2, "Find in the scene", "Ctrl+F", "search", Needs::document},
    {findAction, "Edit", 2, "Find action...", "Ctrl+P", ""},

    {selectAll, "Select", 0, "All", "Ctrl+A", "", Needs::points},
    {selectNone, "Select", 0, "None", "Ctrl+Shift+A", "", Needs::selection},
    {selectInverse, "Select", 0, "Invert", "Ctrl+I", "", Needs::points},
    {selectMoved, "Select", 1, "Moved", "", "", Needs::points},
    {selectDisabled, "Select", 1, "Disabled", "", "", Needs::points},
    {selectChildren, "Select", 2, "Children", "", "", Needs::selection},
    {selectParents, "Select", 2, "Parents", "", "", Needs::selection},
    {levelUp, "Select", 3, "Coarser level", "PgUp", "", Needs::coarser},
    {levelDown, "Select", 3, "Finer level", "PgDown", "", Needs::finer},
    {nextPoint, "Select", 4, "Next point", "]", "", Needs::points},
    {previousPoint, "Select", 4, "Previous point", "[", "", Needs::points},

    {enablePoints, "Points", 0, "Enable", "Ctrl+Alt+E", "eye", Needs::selection},
    {disablePoints, "Points", 0, "Disable", "Ctrl+Alt+D", "eye-off", Needs::selection},
    {hidePoints, "Points", 1, "Hide", "H", "", Needs::selection},
    {showAllPoints, "Points", 1, "Show all", "Alt+H", "", Needs::document},
    {showOnlySelected, "Points", 1, "Show only the selected", "Shift+H", "", Needs::selection},
    {lockPoints, "Points", 2, "Lock", "Ctrl+L", "lock", Needs::selection},
    {unlockPoints, "Points", 2, "Unlock", "", "unlock", Needs::selection},
    {poseToRest, "Points", 3, "Back to rest", "Alt+G", "undo", Needs::selection},
    {resetAll, "Points", 3, "All back to rest", "Alt+Shift+G", "", Needs::points},
    {refineHere, "Points", 4, "Refine here", "Ctrl+Alt+R", "refine", Needs::selection},
    {addCoarserLevel, "Points", 5, "Add a coarser level", "", "add", Needs::points},
    {removeCoarsestLevel, "Points", 5, "Remove the coarsest level", "", "remove", Needs::points},
    {placeAgain, "Points", 4, "Place again", "Ctrl+Alt+P", "place", Needs::document},

    {toolSelect, "Deform", 0, "Select", "Q", "select", Needs::document, true},
    {toolMove, "Deform", 0, "Move", "G", "move", Needs::document, true},
    {toolRotate, "Deform", 0, "Rotate", "R", "rotate", Needs::document, true},
    {toolScale, "Deform", 0, "Scale", "S", "scale", Needs::document, true},
    {toolAdd, "Deform", 0, "Add points", "A", "add", Needs::document, true},
    {snap, "Deform", 1, "Snap", "Shift+S", "snap", Needs::document, true},
    {level1, "Deform", -1, "Level 1", "1", "", Needs::document, true},
    {level2, "Deform", -1, "Level 2", "2", "", Needs::document, true},
    {level3, "Deform", -1, "Level 3", "3", "", Needs::document, true},
    {level4, "Deform", -1, "Level 4", "4", "", Needs::document, true},
    {level5, "Deform", -1, "Level 5", "5", "", Needs::document, true},
    {level6, "Deform", -1, "Level 6", "6", "", Needs::document, true},
    {level7, "Deform", -1, "Level 7", "7", "", Needs::document, true},
    {level8, "Deform", -1, "Level 8", "8", "", Needs::document, true},
    {level9, "Deform", -1, "Level 9", "9", "", Needs::document, true},

    {displayShaded, "View", 0, "Shaded", "Shift+1", "shaded", Needs::document, true},
    {displayWire, "View", 0, "Wire on shaded", "Shift+2", "wire", Needs::document, true},
    {displaySeeThrough, "View", 0, "See through", "Shift+3", "see-through", Needs::document, true},
    {showGhost, "View", 1, "Before, as a ghost", "Shift+B", "ghost", Needs::document, true},
    {showRegions, "View", 1, "Regions of all points", "I", "region", Needs::document, true},
    {showGrid, "View", 1, "Ground grid", "Ctrl+G", "grid", Needs::document, true},
    {hierarchyNone, "View", -1, "No hierarchy", "", "", Needs::document, true},
    {hierarchySelection, "View", -1, "Hierarchy of the selection", "T", "", Needs::document, true},
    {hierarchyAll, "View", -1, "Hierarchy of all points", "Shift+T", "", Needs::document, true},
    {frameSelection, "View", 2, "Frame selection", "F", "frame", Needs::document},
    {frameAll, "View", 2, "Frame all", "Home", "", Needs::document},
    {viewFront, "View", -1, "Front", "Num+1; Alt+1", "", Needs::document},
    {viewRight, "View", -1, "Right", "Num+3; Alt+3", "", Needs::document},
    {viewTop, "View", -1, "Top", "Num+7; Alt+7", "", Needs::document},
    {viewBack, "View", -1, "Back", "Ctrl+Num+1", "", Needs::document},
    {viewLeft, "View", -1, "Left", "Ctrl+Num+3", "", Needs::document},
    {viewBottom, "View", -1, "Bottom", "Ctrl+Num+7", "", Needs::document},
    {orthographic, "View", 3, "Orthographic", "Num+5; Alt+5", "perspective", Needs::document, true},
    {fullScreen, "View", 4, "Full screen", "F11", "", Needs::nothing, true},

    {showScene, "Window", 0, "Scene", "F3", "", Needs::document, true},
    {showInspector, "Window", 0, "Inspector", "F4", "", Needs::document, true},
    {showPlacement, "Window", 0, "Placement", "F5", "", Needs::document, true},
    {showHistory, "Window", 0, "History", "F7", "", Needs::document, true},
    {showMessages, "Window", 0, "Messages", "F8", "", Needs::document, true},
    {hideDocks, "Window", 1, "Hide all docks", "Ctrl+Space", "", Needs::document, true},
    {nextPane, "Window", 1, "Next pane", "F6", ""},
    {themeSystem, "Window", -1, "As the system", "", "", Needs::nothing, true},
    {themeDark, "Window", -1, "Dark", "", "", Needs::nothing, true},
    {themeLight, "Window", -1, "Light", "", "", Needs::nothing, true},
    {resetLayout, "Window", 2, "Reset layout", "", "", Needs::document},

    {shortcuts, "Help", 0, "Shortcuts", "F1", ""},
    {about, "Help", 0, "About PB-FFD Workbench", "", ""},
};
static_assert(std::size(rows) == static_cast<std::size_t>(count_));

}  // namespace

std::span<const ActionRow> actionTable() {
  return rows;
}

}  // namespace pbffd::ui
