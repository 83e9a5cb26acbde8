#pragma once

#include <QTreeView>

#include <functional>
#include <map>
#include <set>
#include <tuple>

namespace pbffd::ui {

class Document;
class SceneModel;
class Theme;

/// The tree of the scene dock: its selection and the document's are one; rows are drawn on amber where
/// selected, on a hint of it where they are parents or children of the selection, and on teal where they are
/// the edit level.
class SceneTree : public QTreeView {
  Q_OBJECT

 public:
  SceneTree(SceneModel& model, Document& document, const Theme& theme, QWidget* parent = nullptr);

  void renameCurrent();

 Q_SIGNALS:
  void menuAsked(const QPoint& globalPosition);

 protected:
  void drawRow(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void drawBranches(QPainter* painter, const QRect& rect, const QModelIndex& index) const override;
  QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                       const QEvent* event) const override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  using RowKey = std::tuple<int, int, int>;  ///< row, level, kind

  static RowKey keyOf(const QModelIndex& index);
  void rememberExpansion();
  void restoreExpansion();
  void renumberLevels();
  void showBranchesOf(const QModelIndex& active);
  void forEachBranch(const std::function<void(const QModelIndex&)>& visit) const;
  bool isMarkedAsRelated(const QModelIndex& index) const;
  QModelIndexList takeRowsOf(int level);
  void takeSelection();
  void showSelection();

  SceneModel& model_;
  Document& document_;
  const Theme& theme_;
  std::map<RowKey, bool> isExpandedBefore_;
  std::set<RowKey> opened_;  ///< branches that were opened for the edit level or the selection alone
  int levelCount_ = 0;       ///< by which the levels in the keys count
  bool isSynchronizing_ = false;
};

}  // namespace pbffd::ui
