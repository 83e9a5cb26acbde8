#include "ui/views/overlays.h"

#include "ui/document/theme.h"

#include <QFontMetrics>
#include <QPainter>

#include <algorithm>

namespace pbffd::ui {
namespace {

constexpr int boxHeight = 26;
constexpr int boxPadding = 10;
constexpr int gap = 8;
constexpr int barWidth = 3;
/// From the place that a box stands beside.
constexpr double besideX = 28.0;
constexpr double besideY = -34.0;
constexpr int margin = 6;
constexpr double radius = 6.0;

QFont sized(QFont font, int pixels, bool bold = false) {
  font.setPixelSize(pixels);
  font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
  return font;
}

}  // namespace

QString pointTitle(const ControlPoint& point) {
  const QString name = point.name.empty() ? QObject::tr("Point") : QString::fromStdString(point.name);
  return QStringLiteral("%1 %2").arg(name).arg(point.id);
}

QString kindName(PointKind kind) {
  switch (kind) {
    case PointKind::interior:
      return QObject::tr("interior");
    case PointKind::exterior:
      return QObject::tr("exterior");
    case PointKind::manual:
      return QObject::tr("manual");
    case PointKind::merged:
      return QObject::tr("merged");
    case PointKind::curve:
      break;
  }
  return QObject::tr("curve");
}

OverlayBox::OverlayBox(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
  hide();
}

void OverlayBox::placeBeside(const QPointF& at, const QRect& room) {
  const QSize wanted = sizeHint();
  const QRect places = room.adjusted(margin, margin, -margin - wanted.width(), -margin - wanted.height());
  double x = at.x() + besideX;
  if (x > places.right() + 1) {
    x = at.x() - besideX - wanted.width();
  }
  double y = at.y() + besideY;
  if (y < places.top()) {
    y = at.y() - besideY - wanted.height();
  }
  const int left = std::clamp(qRound(x), places.left(), std::max(places.left(), places.right() + 1));
  const int top = std::clamp(qRound(y), places.top(), std::max(places.top(), places.bottom() + 1));
  const QRect place(QPoint(left, top), wanted);
  if (isHidden() || geometry() != place) {
    setGeometry(place);
    show();
    raise();
  }
}

void OverlayBox::paintBackground(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme_.color(QStringLiteral("line")), 1.0));
  painter.setBrush(theme_.color(QStringLiteral("overlay")));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
}

void NameTag::setPoint(const ControlPoint& point) {
  QString text = tr("%1, %2").arg(pointTitle(point), kindName(point.kind));
  if (!point.enabled) {
    text = tr("%1, disabled").arg(text);
  }
  if (text != text_) {
    text_ = text;
    update();
  }
}

QSize NameTag::sizeHint() const {
  const QFontMetrics metrics(sized(font(), 12));
  return {metrics.horizontalAdvance(text_) + 2 * boxPadding, boxHeight};
}

void NameTag::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintBackground(painter);
  painter.setFont(sized(font(), 12));
  painter.setPen(theme().color(QStringLiteral("text")));
  painter.drawText(rect(), Qt::AlignCenter, text_);
}

void ReadOutBox::setText(const QString& value, const QString& hint, const QColor& bar) {
  value_ = value;
  hint_ = hint;
  bar_ = bar;
  if (value.isEmpty()) {
    hide();
  }
  update();
}

QFont ReadOutBox::valueFont() const {
  return sized(font(), 13, true);
}

QSize ReadOutBox::sizeHint() const {
  const int bar = bar_.isValid() ? barWidth + gap : 0;
  const int hint = hint_.isEmpty() ? 0 : gap + QFontMetrics(sized(font(), 12)).horizontalAdvance(hint_);
  return {2 * boxPadding + bar + QFontMetrics(valueFont()).horizontalAdvance(value_) + hint, boxHeight};
}

void ReadOutBox::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintBackground(painter);
  int x = boxPadding;
  if (bar_.isValid()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(bar_);
    painter.drawRoundedRect(QRectF(x, 6, barWidth, height() - 12), 1.5, 1.5);
    x += barWidth + gap;
  }
  painter.setFont(valueFont());
  painter.setPen(theme().color(QStringLiteral("text")));
  painter.drawText(QRect(x, 0, width() - x, height()), Qt::AlignVCenter | Qt::AlignLeft, value_);
  x += QFontMetrics(valueFont()).horizontalAdvance(value_) + gap;
  painter.setFont(sized(font(), 12));
  painter.setPen(theme().color(QStringLiteral("text.2")));
  painter.drawText(QRect(x, 0, width() - x, height()), Qt::AlignVCenter | Qt::AlignLeft, hint_);
}

RubberBand::RubberBand(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void RubberBand::setBox(const QRectF& box) {
  if (box.isEmpty()) {
    hide();
    return;
  }
  setGeometry(box.toAlignedRect().adjusted(-1, -1, 1, 1));
  show();
  update();
}

void RubberBand::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QColor color = theme_.color(QStringLiteral("accent"));
  QPen pen(color, 1.0, Qt::DashLine);
  color.setAlphaF(0.10F);
  painter.setPen(pen);
  painter.setBrush(color);
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

}  // namespace pbffd::ui
