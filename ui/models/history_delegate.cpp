#include "ui/models/history_delegate.h"

#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/models/history_model.h"

#include <QPainter>

namespace pbffd::ui {

HistoryDelegate::HistoryDelegate(const Theme& theme, QObject* parent)
    : QStyledItemDelegate(parent), theme_(theme) {}

QSize HistoryDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
  return {100, 24};
}

void HistoryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (index.data(HistoryModel::isCurrentRole).toBool()) {
    painter->fillRect(option.rect, theme_.color("accent.bg"));
  } else if (option.state & QStyle::State_MouseOver) {
    painter->fillRect(option.rect, theme_.color("hover"));
  }
  const bool isFuture = index.data(HistoryModel::isFutureRole).toBool();
  QRect rest = option.rect.adjusted(12, 0, -12, 0);
  drawIcon(*painter, QRectF(rest.left(), rest.center().y() - 6.5, 14, 14),
           index.data(HistoryModel::iconRole).toString(), theme_.color(isFuture ? "disabled" : "text.2"));
  rest.setLeft(rest.left() + 22);

  const QString time = index.data(HistoryModel::timeRole).toString();
  painter->setPen(theme_.color(isFuture ? "disabled" : "text.3"));
  painter->drawText(rest, Qt::AlignRight | Qt::AlignVCenter, time);
  rest.setRight(rest.right() - option.fontMetrics.horizontalAdvance("00:00") - 12);
  if (index.data(HistoryModel::isSavedRole).toBool()) {
    painter->setPen(Qt::NoPen);
    painter->setBrush(theme_.color("ok"));
    painter->drawEllipse(QPointF(rest.right(), rest.center().y() + 1), 3.0, 3.0);
    rest.setRight(rest.right() - 12);
  }
  painter->setPen(theme_.color(isFuture ? "disabled" : "text"));
  painter->drawText(rest, Qt::AlignLeft | Qt::AlignVCenter,
                    option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, rest.width()));
  painter->restore();
}

}  // namespace pbffd::ui
