#include "ui/window/scene_tree.h"

#include "ui/document/document.h"
#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/models/scene_delegate.h"
#include "ui/models/scene_model.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QMouseEvent>
#include <QPainter>
#include <QScopedValueRollback>

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr int indent = 12;
constexpr int switchWidth = 22;
constexpr int leastCountWidth = 48;
constexpr int headerHeight = 26;
/// Of a parent or a child of the selection, as a share of a selected row's colour.
constexpr float relatedTint = 0.55F;

/// The heading: two words and the symbols of the columns below.
class SceneHeader : public QHeaderView {
 public:
  SceneHeader(const Theme& theme, QWidget* parent) : QHeaderView(Qt::Horizontal, parent), theme_(theme) {
    setFixedHeight(headerHeight);
    setSectionsClickable(false);
  }

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int column) const override {
    painter->save();
    painter->setPen(theme_.color("text.3"));
    painter->setFont(Theme::font(11));
    if (column == SceneModel::nameColumn) {
      painter->drawText(rect.adjusted(8, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, tr("Name"));
    } else if (column == SceneModel::countColumn) {
      painter->drawText(rect.adjusted(0, 0, -6, 0), Qt::AlignRight | Qt::AlignVCenter, tr("Count"));
    } else {
      static const char* const icons[] = {"eye", "lock", "check"};
      const QRectF box(rect.center().x() - 5.5, rect.center().y() - 5.5, 12, 12);
      drawIcon(*painter, box, icons[column - SceneModel::eyeColumn], theme_.color("text.3"));
    }
    painter->restore();
  }

 private:
  const Theme& theme_;
};

bool isRow(const QModelIndex& index, SceneModel::Row row) {
  return index.data(SceneModel::rowRole).toInt() == static_cast<int>(row);
}

}  // namespace

SceneTree::SceneTree(SceneModel& model, Document& document, const Theme& theme, QWidget* parent)
    : QTreeView(parent), model_(model), document_(document), theme_(theme) {
  setAccessibleName(tr("Scene"));
  setHeader(new SceneHeader(theme, this));
  setModel(&model);
  setItemDelegate(new SceneDelegate(theme, this));
  setUniformRowHeights(true);
  setIndentation(indent);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setEditTriggers(QAbstractItemView::EditKeyPressed);
  setExpandsOnDoubleClick(false);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMouseTracking(true);
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(18);
  header()->setSectionResizeMode(QHeaderView::Fixed);
  header()->setSectionResizeMode(SceneModel::nameColumn, QHeaderView::Stretch);
  for (const int column : {SceneModel::eyeColumn, SceneModel::lockColumn, SceneModel::tickColumn}) {
    header()->resizeSection(column, switchWidth);
  }
  connect(&model, &QAbstractItemModel::modelAboutToBeReset, this, &SceneTree::rememberExpansion);
  connect(&model, &QAbstractItemModel::modelReset, this, &SceneTree::restoreExpansion);
  connect(&document, &Document::opened, this, [this] {
    isExpandedBefore_.clear();
    opened_.clear();
    restoreExpansion();
  });
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &SceneTree::takeSelection);
  connect(&document.selection(), &Selection::changed, this, &SceneTree::showSelection);
  connect(&theme, &Theme::changed, viewport(), qOverload<>(&QWidget::update));
  restoreExpansion();
}

SceneTree::RowKey SceneTree::keyOf(const QModelIndex& index) {
  return {index.data(SceneModel::rowRole).toInt(), index.data(SceneModel::levelRole).toInt(),
          index.data(SceneModel::kindRole).toInt()};
}

void SceneTree::forEachBranch(const std::function<void(const QModelIndex&)>& visit) const {
  if (model_.rowCount() == 0) {
    return;
  }
  const QModelIndex controls = model_.controlsIndex();
  visit(controls);
  for (int level = 0; level < model_.rowCount(controls); ++level) {
    const QModelIndex levelRow = model_.index(level, 0, controls);
    visit(levelRow);
    for (int group = 0; group < model_.rowCount(levelRow); ++group) {
      visit(model_.index(group, 0, levelRow));
    }
  }
}

/// Of branches that have something to show: an empty one says nothing about what is wanted.
void SceneTree::rememberExpansion() {
  if (!model_.isFiltered()) {
    forEachBranch([&](const QModelIndex& index) {
      if (model_.rowCount(index) > 0) {
        isExpandedBefore_[keyOf(index)] = isExpanded(index);
      }
    });
  }
}

/// Levels come and go at the coarse end, where their numbers begin.
void SceneTree::renumberLevels() {
  const int count = document_.isOpen() ? static_cast<int>(document_.shown().controls.levels.size()) : 0;
  const int by = count - std::exchange(levelCount_, count);
  const auto renumbered = [&](RowKey key) {
    std::get<1>(key) += std::get<0>(key) == static_cast<int>(SceneModel::Row::controls) ? 0 : by;
    return key;
  };
  std::map<RowKey, bool> isExpandedNow;
  for (const auto& [key, isOpen] : isExpandedBefore_) {
    isExpandedNow.emplace(renumbered(key), isOpen);
  }
  std::set<RowKey> opened;
  for (const RowKey& key : opened_) {
    opened.insert(renumbered(key));
  }
  isExpandedBefore_ = std::move(isExpandedNow);
  opened_ = std::move(opened);
}

/// What was open stays open; of branches that were not there before the control set is open, and the edit
/// level. A filter opens everything that it leaves.
void SceneTree::restoreExpansion() {
  renumberLevels();
  const QString widest = model_.index(0, SceneModel::countColumn).data().toString();
  header()->resizeSection(SceneModel::countColumn,
                          std::max(leastCountWidth, fontMetrics().horizontalAdvance(widest) + 12));
  forEachBranch([&](const QModelIndex& index) {
    const auto found = isExpandedBefore_.find(keyOf(index));
    const bool isOpen =
        found == isExpandedBefore_.end() ? isRow(index, SceneModel::Row::controls) : found->second;
    setExpanded(index, model_.isFiltered() || isOpen);
  });
  showSelection();
}

/// Opens the edit level and the group of the active point, and closes again what was opened like this before:
/// the rows of the levels, with what they say of the selection, stay near each other.
void SceneTree::showBranchesOf(const QModelIndex& active) {
  forEachBranch([&](const QModelIndex& branch) {
    const bool isWanted =
        branch.data(SceneModel::isEditLevelRole).toBool() || (active.isValid() && active.parent() == branch);
    if (isWanted && !isExpanded(branch)) {
      opened_.insert(keyOf(branch));
      expand(branch);
    } else if (!isWanted && opened_.erase(keyOf(branch)) > 0) {
      collapse(branch);
    }
  });
}

/// The selected rows of the level's points, from top to bottom. Those of other levels are not selected any
/// more: the edit level alone has a selection.
QModelIndexList SceneTree::takeRowsOf(int level) {
  QModelIndexList rows;
  QItemSelection others;
  for (const QModelIndex& row : selectionModel()->selectedRows()) {
    if (!isRow(row, SceneModel::Row::point)) {
      continue;
    }
    if (row.data(SceneModel::levelRole).toInt() == level) {
      rows.append(row);
    } else {
      others.select(row, row);
    }
  }
  if (!others.isEmpty()) {
    selectionModel()->select(others, QItemSelectionModel::Deselect | QItemSelectionModel::Rows);
  }
  const auto place = [](const QModelIndex& row) { return std::pair(row.parent().row(), row.row()); };
  std::sort(rows.begin(), rows.end(),
            [&](const QModelIndex& a, const QModelIndex& b) { return place(a) < place(b); });
  return rows;
}

void SceneTree::takeSelection() {
  if (isSynchronizing_) {
    return;
  }
  const QScopedValueRollback guard(isSynchronizing_, true);
  const QModelIndex current = currentIndex();
  const int level = isRow(current, SceneModel::Row::point) ? current.data(SceneModel::levelRole).toInt()
                                                           : document_.selection().level();
  std::vector<PointId> rows;
  for (const QModelIndex& row : takeRowsOf(level)) {
    rows.push_back(row.data(SceneModel::pointRole).toLongLong());
  }
  // The order in which they were selected is kept; the row that was clicked is the active point.
  document_.selection().setLevel(level);
  std::unordered_set<PointId> chosen(rows.begin(), rows.end());
  std::vector<PointId> points;
  for (const PointId point : document_.selection().points()) {
    if (chosen.erase(point) > 0) {
      points.push_back(point);
    }
  }
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(points),
               [&](PointId point) { return chosen.contains(point); });
  const PointId clicked = current.data(SceneModel::pointRole).toLongLong();
  if (const auto at = std::find(points.begin(), points.end(), clicked); at != points.end()) {
    std::rotate(at, at + 1, points.end());
  }
  document_.selection().replace(std::move(points));
}

void SceneTree::showSelection() {
  if (isSynchronizing_) {
    return;
  }
  const QScopedValueRollback guard(isSynchronizing_, true);
  const Selection& selection = document_.selection();
  selectionModel()->select(model_.rowsOf(selection.level(), selection.points()),
                           QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  const QModelIndex active = model_.pointIndex(selection.level(), selection.active());
  if (!document_.isPreviewing() && !model_.isFiltered()) {
    showBranchesOf(active);
  }
  if (active.isValid() && !document_.isPreviewing()) {
    selectionModel()->setCurrentIndex(active, QItemSelectionModel::NoUpdate);
    scrollTo(active);
  }
  viewport()->update();
}

void SceneTree::renameCurrent() {
  const Selection& selection = document_.selection();
  const QModelIndex active = model_.pointIndex(selection.level(), selection.active());
  if (active.isValid()) {
    scrollTo(active);
    edit(active);
  }
}

/// A branch stands for what it hides, and only as long as it hides it.
bool SceneTree::isMarkedAsRelated(const QModelIndex& index) const {
  return index.data(SceneModel::relationRole).toInt() != static_cast<int>(Relation::none) && !isExpanded(index);
}

void SceneTree::drawRow(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const bool isSelected = selectionModel()->isSelected(index);
  const bool isHovered = option.rect.contains(viewport()->mapFromGlobal(QCursor::pos())) && underMouse();
  QRect row = option.rect;
  row.setLeft(0);
  row.setRight(viewport()->width());
  if (isSelected) {
    painter->fillRect(row, theme_.color("select.bg"));
  } else if (index.data(SceneModel::isEditLevelRole).toBool()) {
    painter->fillRect(row, theme_.color("accent.bg"));
  } else if (isHovered) {
    painter->fillRect(row, theme_.color("hover"));
  } else if (isMarkedAsRelated(index)) {
    QColor tint = theme_.color("select.bg");
    tint.setAlphaF(relatedTint);
    painter->fillRect(row, tint);
  }
  QStyleOptionViewItem plain = option;
  plain.state &= ~(QStyle::State_Selected | QStyle::State_HasFocus);
  plain.palette.setColor(QPalette::Highlight, Qt::transparent);
  QTreeView::drawRow(painter, plain, index);
  if (hasFocus() && index.siblingAtColumn(0) == currentIndex().siblingAtColumn(0)) {
    painter->setPen(theme_.color("accent"));
    painter->setBrush(Qt::NoBrush);
    painter->drawRect(row.adjusted(0, 0, -1, -1));
  }
}

void SceneTree::drawBranches(QPainter* painter, const QRect& rect, const QModelIndex& index) const {
  if (model_.hasChildren(index)) {
    const QRectF box(rect.right() - indent + 1.5, rect.center().y() - 5.5, 12, 12);
    drawIcon(*painter, box, isExpanded(index) ? "chevron-down" : "chevron-right", theme_.color("text.3"));
  }
}

QItemSelectionModel::SelectionFlags SceneTree::selectionCommand(const QModelIndex& index,
                                                                const QEvent* event) const {
  const bool isSwitch = index.isValid() && index.column() >= SceneModel::eyeColumn;
  const bool isMouse =
      event != nullptr && (event->type() == QEvent::MouseButtonPress ||
                           event->type() == QEvent::MouseButtonRelease || event->type() == QEvent::MouseMove);
  if (isSwitch && isMouse) {
    return QItemSelectionModel::NoUpdate;
  }
  return QTreeView::selectionCommand(index, event);
}

void SceneTree::mouseDoubleClickEvent(QMouseEvent* event) {
  const QModelIndex index = indexAt(event->position().toPoint());
  if (index.column() >= SceneModel::eyeColumn) {
    return mousePressEvent(event);
  }
  if (isRow(index, SceneModel::Row::level)) {
    document_.selection().setLevel(index.data(SceneModel::levelRole).toInt());
  } else if (isRow(index, SceneModel::Row::point)) {
    renameCurrent();
    return;
  } else if (index.isValid()) {
    const QModelIndex row = index.siblingAtColumn(0);
    setExpanded(row, !isExpanded(row));
  }
}

void SceneTree::contextMenuEvent(QContextMenuEvent* event) {
  Q_EMIT menuAsked(event->globalPos());
}

void SceneTree::keyPressEvent(QKeyEvent* event) {
  const QModelIndex current = currentIndex();
  if (event->key() == Qt::Key_Return && isRow(current, SceneModel::Row::level)) {
    document_.selection().setLevel(current.data(SceneModel::levelRole).toInt());
    return;
  }
  if (event->key() == Qt::Key_Space && isRow(current, SceneModel::Row::point)) {
    const QModelIndex tick = current.siblingAtColumn(SceneModel::tickColumn);
    const bool on = tick.data(Qt::CheckStateRole).toInt() == Qt::Checked;
    model_.setData(tick, on ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
    return;
  }
  QTreeView::keyPressEvent(event);
}

}  // namespace pbffd::ui
