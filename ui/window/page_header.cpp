#include "ui/window/page_header.h"

#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/window/labels.h"

#include <QPainter>
#include <QVBoxLayout>

namespace pbffd::ui {

PageHeader::PageHeader(const Theme& theme, QWidget* parent)
    : QFrame(parent), theme_(theme), title_(makeLabel({}, "heading")), detail_(makeLabel({}, "label")) {
  setProperty("role", "section");
  title_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  detail_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(48, 11, 12, 11);
  column->setSpacing(1);
  column->addWidget(title_);
  column->addWidget(detail_);
}

void PageHeader::show(const Content& content) {
  content_ = content;
  title_->setText(content.title);
  detail_->setText(content.detail);
  update();
}

void PageHeader::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  if (content_.icon.isEmpty()) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF tile(12, height() / 2.0 - 13.5, 26, 26);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_.color(content_.groundToken));
  painter.drawRoundedRect(tile, 5, 5);
  drawIcon(painter, tile.adjusted(5, 5, -5, -5), content_.icon, theme_.color(content_.iconToken));
}

}  // namespace pbffd::ui
