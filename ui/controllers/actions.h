#pragma once

#include <QAction>
#include <QObject>

#include <map>
#include <vector>

class QActionGroup;
class QMenu;

namespace pbffd::ui {

class Document;
class Theme;
class ViewState;

enum class ActionId {
  openMesh,
  openProject,
  save,
  saveAs,
  exportMesh,
  exportPicture,
  runEdits,
  saveEdits,
  applyToOther,
  closeDocument,
  quit,

  undo,
  redo,
  rename,
  removePoints,
  find,
  findAction,

  selectAll,
  selectNone,
  selectInverse,
  selectMoved,
  selectDisabled,
  selectChildren,
  selectParents,
  levelUp,
  levelDown,
  nextPoint,
  previousPoint,

  enablePoints,
  disablePoints,
  hidePoints,
  showAllPoints,
  showOnlySelected,
  lockPoints,
  unlockPoints,
  poseToRest,
  resetAll,
  refineHere,
  addCoarserLevel,
  removeCoarsestLevel,
  placeAgain,

  toolSelect,
  toolMove,
  toolRotate,
  toolScale,
  toolAdd,
  snap,
  level1,
  level2,
  level3,
  level4,
  level5,
  level6,
  level7,
  level8,
  level9,

  displayShaded,
  displayWire,
  displaySeeThrough,
  showGhost,
  showRegions,
  showGrid,
  hierarchyNone,
  hierarchySelection,
  hierarchyAll,
  frameSelection,
  frameAll,
  viewFront,
  viewRight,
  viewTop,
  viewBack,
  viewLeft,
  viewBottom,
  orthographic,
  fullScreen,

  showScene,
  showInspector,
  showPlacement,
  showHistory,
  showMessages,
  hideDocks,
  nextPane,
  themeSystem,
  themeDark,
  themeLight,
  resetLayout,

  shortcuts,
  about,
  count_
};

/// Every action of the program, once: its text, keys, menu and icon come from one table, and it is greyed
/// with the reason in its tool tip. Who carries an action out connects to it.
class Actions : public QObject {
  Q_OBJECT

 public:
  Actions(Document& document, ViewState& view, const Theme& theme, QObject* parent = nullptr);

  QAction* operator[](ActionId id) const { return actions_.at(static_cast<std::size_t>(id)); }
  const std::vector<QAction*>& all() const { return actions_; }

  /// The menu that an action belongs to: "File", without the mark of its mnemonic.
  static QString menuOf(ActionId id);

  /// Adds the actions of a menu, with separators between their groups; those of a submenu are left out.
  void fill(QMenu& menu, const QString& name) const;
  /// Single letters and figures act only while one of these widgets has the focus.
  void addLetterKeysTo(QWidget& widget) const;

  /// Why an action cannot be used now; empty when it can.
  QString reasonAgainst(ActionId id) const;
  /// Greys what cannot be used now. Called by itself when the document, its selection or its history changes.
  void refresh();

 private:
  void create();
  void makeGroups();
  void synchronizeChecks();

  Document& document_;
  ViewState& view_;
  const Theme& theme_;
  std::vector<QAction*> actions_;
};

}  // namespace pbffd::ui
