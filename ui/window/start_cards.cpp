#include "ui/window/start_cards.h"

#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/window/labels.h"

#include <QDir>
#include <QFileInfo>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>

namespace pbffd::ui {
namespace {

constexpr double cardRadius = 10.0;
constexpr int captionHeight = 32;

/// The ground of the render view, so that pictures look as the mesh will.
QLinearGradient viewGround(const Theme& theme, const QRectF& rect) {
  QLinearGradient ground(rect.bottomLeft(), rect.topLeft());
  ground.setColorAt(0.0, theme.color("view.bottom"));
  ground.setColorAt(1.0, theme.color("view.top"));
  return ground;
}

void drawFitted(QPainter& painter, const QRectF& rect, const QImage& picture) {
  if (picture.isNull()) {
    return;
  }
  const QSizeF size = QSizeF(picture.size()).scaled(rect.size(), Qt::KeepAspectRatio);
  QRectF target(QPointF(), size);
  target.moveCenter(rect.center());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(target, picture);
}

/// "~/models": the folder as a person says it.
QString friendlyFolder(const QString& path) {
  const QString folder = QFileInfo(path).absolutePath();
  const QString home = QDir::homePath();
  return folder.startsWith(home) ? "~" + folder.mid(home.size()) : folder;
}

bool isActivation(const QKeyEvent& event) {
  return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

}  // namespace

SampleCard::SampleCard(const Theme& theme, const QString& name, QWidget* parent)
    : QAbstractButton(parent), theme_(theme) {
  setText(name);
  setAccessibleName(tr("Sample %1").arg(name));
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setMinimumSize(200, 150);
  setMouseTracking(true);
  connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void SampleCard::setPicture(const QImage& picture, int triangles) {
  picture_ = picture;
  count_ = triangles > 0 ? tr("%1 triangles").arg(counted(triangles)) : QString();
  update();
}

void SampleCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
  QPainterPath shape;
  shape.addRoundedRect(box, cardRadius, cardRadius);
  painter.setClipPath(shape);
  const QRectF view = box.adjusted(0, 0, 0, -captionHeight);
  painter.fillRect(view, viewGround(theme_, view));
  painter.fillRect(box.adjusted(0, view.height(), 0, 0), theme_.color("panel"));
  drawFitted(painter, view.adjusted(8, 8, -8, -8), picture_);
  painter.setClipping(false);
  const bool isMarked = hasFocus() || isPointedAt_;
  painter.setPen(QPen(theme_.color(isMarked ? "accent" : "line"), hasFocus() ? 2.0 : 1.0));
  painter.drawPath(shape);
  const QRectF caption = box.adjusted(14, view.height(), -14, 0);
  painter.setPen(theme_.color("text"));
  painter.setFont(Theme::font(12, QFont::DemiBold));
  painter.drawText(caption, Qt::AlignLeft | Qt::AlignVCenter, text());
  painter.setPen(theme_.color("text.2"));
  painter.setFont(Theme::font(12));
  painter.drawText(caption, Qt::AlignRight | Qt::AlignVCenter, count_);
}

void SampleCard::mouseMoveEvent(QMouseEvent* event) {
  QAbstractButton::mouseMoveEvent(event);
  isPointedAt_ = true;
  update();
}

void SampleCard::leaveEvent(QEvent* event) {
  QAbstractButton::leaveEvent(event);
  isPointedAt_ = false;
  update();
}

void SampleCard::keyPressEvent(QKeyEvent* event) {
  if (isActivation(*event)) {
    click();
  } else {
    QAbstractButton::keyPressEvent(event);
  }
}

RecentRow::RecentRow(const Theme& theme, const Content& content, QWidget* parent)
    : QAbstractButton(parent), theme_(theme), content_(content) {
  setText(QFileInfo(content.path).fileName());
  setAccessibleName(content.isMissing ? tr("%1, not found").arg(text()) : text());
  setToolTip(QDir::toNativeSeparators(content.path));
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void RecentRow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (underMouse() || hasFocus()) {
    painter.setPen(hasFocus() ? QPen(theme_.color("accent"), 2.0) : QPen(Qt::NoPen));
    painter.setBrush(underMouse() ? theme_.color("hover") : QColor(Qt::transparent));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
  }
  const QRectF tile(7, 3, 74, 42);
  painter.setPen(Qt::NoPen);
  painter.setBrush(viewGround(theme_, tile));
  painter.drawRoundedRect(tile, 4, 4);
  painter.setOpacity(content_.isMissing ? 0.4 : 1.0);
  drawFitted(painter, tile.adjusted(3, 3, -3, -3), content_.picture);
  painter.setOpacity(1.0);

  const QRectF upper(93, 5, width() - 93 - 8, 19);
  const QRectF lower(93, 24, width() - 93 - 8, 19);
  painter.setFont(Theme::font(12, QFont::DemiBold));
  painter.setPen(theme_.color(content_.isMissing ? "text.3" : "text"));
  painter.drawText(
      upper, Qt::AlignLeft | Qt::AlignVCenter,
      painter.fontMetrics().elidedText(text(), Qt::ElideMiddle, static_cast<int>(upper.width()) - 80));
  painter.setFont(Theme::font(12));
  painter.setPen(theme_.color("text.2"));
  painter.drawText(upper, Qt::AlignRight | Qt::AlignVCenter, content_.when);
  if (!content_.isMissing && content_.points > 0) {
    painter.drawText(lower, Qt::AlignRight | Qt::AlignVCenter, tr("%1 points").arg(counted(content_.points)));
  }
  const QString folder = friendlyFolder(content_.path);
  painter.setPen(theme_.color(content_.isMissing ? "warn" : "text.2"));
  painter.drawText(
      lower, Qt::AlignLeft | Qt::AlignVCenter,
      painter.fontMetrics().elidedText(content_.isMissing ? tr("Not found in %1").arg(folder) : folder,
                                       Qt::ElideMiddle, static_cast<int>(lower.width()) - 80));
}

void RecentRow::enterEvent(QEnterEvent* event) {
  QAbstractButton::enterEvent(event);
  update();
}

void RecentRow::leaveEvent(QEvent* event) {
  QAbstractButton::leaveEvent(event);
  update();
}

void RecentRow::keyPressEvent(QKeyEvent* event) {
  if (isActivation(*event)) {
    click();
  } else {
    QAbstractButton::keyPressEvent(event);
  }
}

DropArea::DropArea(const Theme& theme, QWidget* parent)
    : QFrame(parent), theme_(theme), title_(makeLabel({}, "value")), detail_(makeLabel({}, "label")) {
  setProperty("role", "drop");
  setMinimumHeight(130);
  setMaximumHeight(190);
  title_->setAlignment(Qt::AlignHCenter);
  title_->setStyleSheet("font-size: 15px; font-weight: 600;");
  detail_->setAlignment(Qt::AlignHCenter);
  detail_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 64, 20, 20);
  column->setSpacing(6);
  column->addStretch();
  column->addWidget(title_);
  column->addWidget(detail_);
  column->addStretch();
  showDrag(false, {});
}

void DropArea::showDrag(bool isOver, const QString& reason) {
  const bool isRefused = isOver && !reason.isEmpty();
  setStyleProperty(this, "state", !isOver ? "idle" : isRefused ? "refused" : "over");
  title_->setText(isRefused ? tr("This cannot be opened") : tr("Drop a mesh or a project here"));
  detail_->setText(isRefused ? reason : tr("OBJ, PLY, STL, OFF or PBFFD"));
}

void DropArea::paintEvent(QPaintEvent* event) {
  QFrame::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool isRefused = property("state") == "refused";
  drawIcon(painter, QRectF(width() / 2.0 - 20, title_->y() - 48, 40, 40), isRefused ? "error" : "download",
           theme_.color(isRefused ? "error" : "accent"));
}

}  // namespace pbffd::ui
