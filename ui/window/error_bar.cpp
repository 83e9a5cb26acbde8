#include "ui/window/error_bar.h"

#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/window/dock.h"
#include "ui/window/labels.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

namespace pbffd::ui {
namespace {

constexpr int warningMilliseconds = 8000;

}  // namespace

ErrorBar::ErrorBar(const Theme& theme, QWidget* parent)
    : QFrame(parent), theme_(theme), text_(makeLabel({}, "value")) {
  setObjectName("errorBar");
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  QToolButton* shut = makeIconButton(theme, "close", tr("Close this message"));
  connect(shut, &QToolButton::clicked, this, &QWidget::hide);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(40, 9, 8, 9);
  row->setSpacing(10);
  row->addWidget(text_, 1);
  row->addWidget(shut, 0, Qt::AlignTop);
  timer_.setSingleShot(true);
  timer_.setInterval(warningMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &ErrorBar::maybeClose);
  hide();
}

QString ErrorBar::text() const {
  return text_->text();
}

void ErrorBar::show(Severity severity, const QString& text) {
  // A warning does not take the place of an error that was not closed yet.
  if (isVisible() && severity_ == Severity::error && severity != Severity::error) {
    return;
  }
  severity_ = severity;
  text_->setText(text);
  setAccessibleName(text);
  QFrame::show();
  raise();
  update();
  if (severity == Severity::error) {
    timer_.stop();
  } else {
    timer_.start();
  }
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
  Q_EMIT sizeChanged();
}

void ErrorBar::maybeClose() {
  const bool isFocused = isAncestorOf(window()->focusWidget());
  if (underMouse() || isFocused) {
    timer_.start();
  } else {
    hide();
  }
}

void ErrorBar::hideEvent(QHideEvent* event) {
  timer_.stop();
  QFrame::hideEvent(event);
}

void ErrorBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool isError = severity_ == Severity::error;
  const QColor color = theme_.color(isError ? "error" : "warn");
  painter.setPen(color);
  painter.setBrush(theme_.color("raised"));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8, 8);
  drawIcon(painter, QRectF(13, 11, 17, 17), isError ? "error" : "warning", color);
}

}  // namespace pbffd::ui
