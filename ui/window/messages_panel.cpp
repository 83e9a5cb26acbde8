#include "ui/window/messages_panel.h"

#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/models/message_model.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QPainter>
#include <QScrollBar>
#include <QStyledItemDelegate>

namespace pbffd::ui {
namespace {

constexpr int textLeft = 36;
constexpr int timeWidth = 48;
constexpr int spacing = 5;

class MessageDelegate : public QStyledItemDelegate {
 public:
  MessageDelegate(const Theme& theme, QListView* view)
      : QStyledItemDelegate(view), theme_(theme), view_(*view) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const int width = view_.viewport()->width() - textLeft - timeWidth;
    const QRect text = option.fontMetrics.boundingRect(QRect(0, 0, std::max(width, 80), 10000),
                                                       Qt::TextWordWrap, index.data().toString());
    return {view_.viewport()->width(), text.height() + 2 * spacing};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    static const char* const icons[] = {"info", "warning", "error"};
    static const char* const tokens[] = {"accent", "warn", "error"};
    const auto severity = static_cast<std::size_t>(index.data(MessageModel::severityRole).toInt());
    painter->save();
    const QRect rest = option.rect.adjusted(0, spacing, 0, -spacing);
    drawIcon(*painter, QRectF(12, rest.top(), 15, 15), icons[severity], theme_.color(tokens[severity]));
    painter->setPen(theme_.color("text.3"));
    painter->drawText(rest.adjusted(0, 0, -12, 0), Qt::AlignRight | Qt::AlignTop,
                      index.data(MessageModel::timeRole).toString());
    painter->setPen(theme_.color("text"));
    painter->drawText(rest.adjusted(textLeft, 0, -timeWidth, 0), Qt::TextWordWrap, index.data().toString());
    painter->restore();
  }

 private:
  const Theme& theme_;
  const QListView& view_;
};

}  // namespace

MessagesPanel::MessagesPanel(MessageModel& messages, const Theme& theme, QWidget* parent)
    : QListView(parent), messages_(messages) {
  setAccessibleName(tr("Messages"));
  setModel(&messages);
  setItemDelegate(new MessageDelegate(theme, this));
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setResizeMode(QListView::Adjust);
  setSelectionMode(QAbstractItemView::NoSelection);
  connect(&messages, &QAbstractItemModel::rowsInserted, this, &QListView::scrollToBottom, Qt::QueuedConnection);
  connect(&theme, &Theme::changed, viewport(), qOverload<>(&QWidget::update));
}

void MessagesPanel::resizeEvent(QResizeEvent* event) {
  QListView::resizeEvent(event);
  // The wrapped heights depend on the width.
  scheduleDelayedItemsLayout();
}

void MessagesPanel::contextMenuEvent(QContextMenuEvent* event) {
  const QModelIndex index = indexAt(event->pos());
  QMenu menu(this);
  if (index.isValid()) {
    const QString text = index.data().toString();
    menu.addAction(tr("Copy"), this, [text] { QApplication::clipboard()->setText(text); });
  }
  menu.addAction(tr("Copy all"), this, [this] { QApplication::clipboard()->setText(messages_.toText()); });
  menu.addAction(tr("Clear"), &messages_, &MessageModel::clear);
  menu.exec(event->globalPos());
}

}  // namespace pbffd::ui
