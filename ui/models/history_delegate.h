#pragma once

#include <QStyledItemDelegate>

namespace pbffd::ui {

class Theme;

/// Draws a history row: icon, text, the dot of the saved state, time; the present state on accent ground,
/// undone steps grey.
class HistoryDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  explicit HistoryDelegate(const Theme& theme, QObject* parent = nullptr);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  const Theme& theme_;
};

}  // namespace pbffd::ui
