#include "ui/views/axis_triad.h"

#include "ui/document/theme.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace pbffd::ui {
namespace {

constexpr int side = 96;
constexpr double armLength = 32.0;
constexpr double ballRadius = 8.5;
constexpr double smallRadius = 5.0;

QString letterOf(int axis) {
  return QString(QLatin1Char(static_cast<char>('X' + axis)));
}

QString tokenOf(int axis) {
  return QStringLiteral("axis.") + letterOf(axis).toLower();
}

}  // namespace

AxisTriad::AxisTriad(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  setFixedSize(side, side);
  setMouseTracking(true);
  setAccessibleName(tr("Axes"));
  setAccessibleDescription(tr("Click an end to look along its axis"));
  connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void AxisTriad::setAxes(const Mat3& cameraAxes) {
  if (cameraAxes_ != cameraAxes) {
    cameraAxes_ = cameraAxes;
    update();
  }
}

std::vector<AxisTriad::End> AxisTriad::ends() const {
  std::vector<End> all;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool isPositive : {true, false}) {
      const Vec3 seen = (isPositive ? 1.0 : -1.0) * cameraAxes_.row(axis).transpose();
      const QPointF at(0.5 * side + armLength * seen.x(), 0.5 * side - armLength * seen.y());
      all.push_back({axis, isPositive, at, seen.z()});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const End& a, const End& b) { return a.depth < b.depth; });
  return all;
}

const AxisTriad::End* AxisTriad::endAt(const std::vector<End>& all, const QPointF& position) const {
  for (auto end = all.rbegin(); end != all.rend(); ++end) {
    const QPointF to = position - end->at;
    if (std::hypot(to.x(), to.y()) <= (end->isPositive ? ballRadius : smallRadius) + 2.0) {
      return &*end;
    }
  }
  return nullptr;
}

void AxisTriad::paintEnd(QPainter& painter, const End& end) const {
  QColor color = theme_.color(tokenOf(end.axis));
  const bool isHovered = end.axis == hoveredAxis_ && end.isPositive == hoveredPositive_;
  if (isHovered) {
    color = theme_.isDark() ? color.lighter(125) : color.darker(125);
  }
  if (!end.isPositive) {
    // Only a place to click: seen when the cursor is near.
    if (hoveredAxis_ >= 0 || underMouse()) {
      QColor faint = color;
      faint.setAlphaF(isHovered ? 1.0F : 0.45F);
      painter.setPen(QPen(faint, 1.5));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(end.at, smallRadius, smallRadius);
    }
    return;
  }
  painter.setPen(QPen(color, 2.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(0.5 * side, 0.5 * side), end.at);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(end.at, ballRadius, ballRadius);
  QFont letter = font();
  letter.setPixelSize(11);
  letter.setBold(true);
  painter.setFont(letter);
  painter.setPen(theme_.isDark() ? theme_.color(QStringLiteral("halo"))
                                 : theme_.color(QStringLiteral("raised")));
  painter.drawText(QRectF(end.at.x() - 10, end.at.y() - 10, 20, 20), Qt::AlignCenter, letterOf(end.axis));
}

void AxisTriad::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const End& end : ends()) {
    paintEnd(painter, end);
  }
}

void AxisTriad::mousePressEvent(QMouseEvent* event) {
  const std::vector<End> all = ends();
  const End* const end = endAt(all, event->position());
  if (event->button() != Qt::LeftButton || end == nullptr) {
    event->ignore();
    return;
  }
  Q_EMIT sideChosen(end->axis, end->isPositive);
}

void AxisTriad::mouseMoveEvent(QMouseEvent* event) {
  const std::vector<End> all = ends();
  const End* const end = endAt(all, event->position());
  hoveredAxis_ = end != nullptr ? end->axis : -1;
  hoveredPositive_ = end != nullptr && end->isPositive;
  setCursor(end != nullptr ? Qt::PointingHandCursor : Qt::ArrowCursor);
  update();
}

void AxisTriad::leaveEvent(QEvent*) {
  hoveredAxis_ = -1;
  update();
}

}  // namespace pbffd::ui
