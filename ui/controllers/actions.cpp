#include "ui/controllers/actions.h"

#include "ui/controllers/action_table.h"
#include "ui/document/document.h"
#include "ui/document/icons.h"
#include "ui/document/job_runner.h"
#include "ui/document/view_state.h"

#include <QAbstractItemView>
#include <QActionGroup>
#include <QMenu>
#include <QWidget>

#include <algorithm>

namespace pbffd::ui {
namespace {

const ActionRow& rowOf(ActionId id) {
  return actionTable()[static_cast<std::size_t>(id)];
}

QList<QKeySequence> keysOf(const ActionRow& row) {
  QList<QKeySequence> keys;
  for (const QString& key : QString(row.keys).split("; ", Qt::SkipEmptyParts)) {
    keys += QKeySequence(key, QKeySequence::PortableText);
  }
  return keys;
}

/// A key that one also types in a text or uses there: without Ctrl and Alt, and no function key.
bool isLetterKey(const QKeySequence& key) {
  const QKeyCombination combination = key[0];
  const bool modified = combination.keyboardModifiers() & (Qt::ControlModifier | Qt::AltModifier);
  const bool isFunctionKey = combination.key() >= Qt::Key_F1 && combination.key() <= Qt::Key_F35;
  return !modified && !isFunctionKey;
}

/// A key that a list needs for itself.
bool movesInLists(const QKeySequence& key) {
  static const QList<QKeySequence> keys{Qt::Key_Home, Qt::Key_PageUp, Qt::Key_PageDown};
  return keys.contains(key);
}

const Level* editLevelOf(const Document& document) {
  const auto& levels = document.shown().controls.levels;
  const auto place = static_cast<std::size_t>(document.editLevel());
  return document.isOpen() && place < levels.size() ? &levels[place] : nullptr;
}

}  // namespace

Actions::Actions(Document& document, ViewState& view, const Theme& theme, QObject* parent)
    : QObject(parent), document_(document), view_(view), theme_(theme) {
  create();
  makeGroups();
  const auto refreshed = [this] { refresh(); };
  connect(&document, &Document::opened, this, refreshed);
  connect(&document, &Document::changed, this, refreshed);
  connect(&document.selection(), &Selection::changed, this, refreshed);
  connect(&document.history(), &QUndoStack::indexChanged, this, refreshed);
  connect(&document.history(), &QUndoStack::undoTextChanged, this, refreshed);
  connect(&document.history(), &QUndoStack::redoTextChanged, this, refreshed);
  connect(&document.jobs(), &JobRunner::started, this, refreshed);
  connect(&document.jobs(), &JobRunner::finished, this, refreshed);
  connect(&view, &ViewState::changed, this, &Actions::synchronizeChecks);
  refresh();
  synchronizeChecks();
}

void Actions::create() {
  for (const ActionRow& row : actionTable()) {
    auto* action = new QAction(tr(row.text), this);
    action->setObjectName(row.text);
    const QList<QKeySequence> keys = keysOf(row);
    action->setShortcuts(keys);
    if (std::any_of(keys.begin(), keys.end(), isLetterKey)) {
      action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    }
    if (*row.icon != '\0') {
      action->setIcon(makeIcon(theme_, row.icon, {"text.2", "accent"}));
    }
    action->setProperty("iconName", row.icon);
    action->setCheckable(row.isCheckable);
    actions_.push_back(action);
  }
}

void Actions::makeGroups() {
  const auto group = [&](ActionId first, ActionId last) {
    auto* made = new QActionGroup(this);
    for (int id = static_cast<int>(first); id <= static_cast<int>(last); ++id) {
      made->addAction(actions_[static_cast<std::size_t>(id)]);
    }
  };
  group(ActionId::toolSelect, ActionId::toolAdd);
  group(ActionId::level1, ActionId::level9);
  group(ActionId::displayShaded, ActionId::displaySeeThrough);
  group(ActionId::hierarchyNone, ActionId::hierarchyAll);
  group(ActionId::themeSystem, ActionId::themeLight);
}

QString Actions::menuOf(ActionId id) {
  return rowOf(id).menu;
}

void Actions::fill(QMenu& menu, const QString& name) const {
  int group = -1;
  for (const ActionRow& row : actionTable()) {
    if (name != row.menu || row.group < 0) {
      continue;
    }
    if (group >= 0 && row.group != group) {
      menu.addSeparator();
    }
    group = row.group;
    menu.addAction((*this)[row.id]);
  }
}

void Actions::addLetterKeysTo(QWidget& widget) const {
  const bool isList = qobject_cast<QAbstractItemView*>(&widget) != nullptr;
  for (QAction* action : actions_) {
    const bool isTaken = isList && movesInLists(action->shortcut());
    if (action->shortcutContext() == Qt::WidgetWithChildrenShortcut && !isTaken) {
      widget.addAction(action);
    }
  }
}

QString Actions::reasonAgainst(ActionId id) const {
  const Needs needs = rowOf(id).needs;
  if (needs == Needs::nothing) {
    return {};
  }
  if (!document_.isOpen()) {
    return tr("Open a mesh or a project first.");
  }
  const Level* level = editLevelOf(document_);
  const int levels = static_cast<int>(document_.shown().controls.levels.size());
  const std::size_t selected = document_.selection().points().size();
  switch (needs) {
    case Needs::points:
      return level != nullptr && !level->empty() ? QString() : tr("There are no control points on this level.");
    case Needs::selection:
      return selected > 0 ? QString() : tr("Select control points first.");
    case Needs::onePoint:
      return selected == 1 ? QString() : tr("Select one control point first.");
    case Needs::undo:
      return document_.history().canUndo() ? QString() : tr("Nothing was done yet.");
    case Needs::redo:
      return document_.history().canRedo() ? QString() : tr("Nothing was undone.");
    case Needs::coarser:
      return document_.selection().level() > 1 ? QString() : tr("This is the coarsest level.");
    case Needs::finer:
      return document_.selection().level() < levels ? QString() : tr("This is the finest level.");
    default:
      break;
  }
  const int wanted = static_cast<int>(id) - static_cast<int>(ActionId::level1) + 1;
  if (id >= ActionId::level1 && id <= ActionId::level9 && wanted > levels) {
    return tr("There are %n level(s).", nullptr, levels);
  }
  return {};
}

void Actions::refresh() {
  for (const ActionRow& row : actionTable()) {
    QAction* action = (*this)[row.id];
    const QString reason = reasonAgainst(row.id);
    action->setEnabled(reason.isEmpty());
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    const QString text = tr(row.text).remove("...");
    action->setToolTip(!reason.isEmpty() ? text + "\n" + reason : key.isEmpty() ? text : text + "  " + key);
    action->setStatusTip(reason);
  }
  const QUndoStack& history = document_.history();
  (*this)[ActionId::undo]->setText(history.canUndo() ? tr("Undo %1").arg(history.undoText()) : tr("Undo"));
  (*this)[ActionId::redo]->setText(history.canRedo() ? tr("Redo %1").arg(history.redoText()) : tr("Redo"));
  // None where the level is beyond those that have a key.
  const int level = document_.selection().level();
  for (int number = 1; number <= 9; ++number) {
    const auto first = static_cast<std::size_t>(ActionId::level1);
    actions_[first + static_cast<std::size_t>(number - 1)]->setChecked(number == level);
  }
}

void Actions::synchronizeChecks() {
  const auto mode = static_cast<std::size_t>(view_.displayMode());
  actions_[static_cast<std::size_t>(ActionId::displayShaded) + mode]->setChecked(true);
  const auto hierarchy = static_cast<std::size_t>(view_.hierarchy());
  actions_[static_cast<std::size_t>(ActionId::hierarchyNone) + hierarchy]->setChecked(true);
  (*this)[ActionId::showGhost]->setChecked(view_.isGhostShown());
  (*this)[ActionId::showRegions]->setChecked(view_.regions() == RegionDisplay::level);
  (*this)[ActionId::showGrid]->setChecked(view_.isGridShown());
  (*this)[ActionId::orthographic]->setChecked(view_.isOrthographic());
}

}  // namespace pbffd::ui
