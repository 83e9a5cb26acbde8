#pragma once

#include <QStyledItemDelegate>

namespace pbffd::ui {

class Theme;

/// Draws the rows of the scene tree: glyphs by kind, quiet numbers, eyes, locks and ticks, which a click
/// turns. The view draws the row's background.
class SceneDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  static constexpr int rowHeight = 24;

  explicit SceneDelegate(const Theme& theme, QObject* parent = nullptr);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const override;

 protected:
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

 private:
  void paintName(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
  void paintCheck(QPainter& painter, const QRect& cell, const QModelIndex& index) const;

  const Theme& theme_;
};

}  // namespace pbffd::ui
