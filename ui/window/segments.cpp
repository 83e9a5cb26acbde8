#include "ui/window/segments.h"

#include "ui/document/theme.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>

namespace pbffd::ui {
namespace {

constexpr int segmentHeight = 26;
constexpr int padding = 9;
constexpr double radius = 6.0;

/// One segment; rounded only at the outer ends of the row.
class SegmentButton : public QAbstractButton {
 public:
  SegmentButton(const Theme& theme, const Segments::Segment& segment, QWidget* parent)
      : QAbstractButton(parent), theme_(theme), count_(segment.count) {
    setCheckable(true);
    setText(segment.text);
    setAccessibleName(segment.accessibleName);
    setToolTip(segment.accessibleName);
    setFocusPolicy(Qt::StrongFocus);
  }

  void setEnds(bool first, bool last) {
    isFirst_ = first;
    isLast_ = last;
  }

  QSize sizeHint() const override {
    const QFontMetrics metrics = fontMetrics();
    const int counted = count_.isEmpty() ? 0 : metrics.horizontalAdvance(count_) + 6;
    return {metrics.horizontalAdvance(text()) + counted + 2 * padding, segmentHeight};
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor line = theme_.color("line");
    QPainterPath shape;
    // The path is longer than the widget where it joins its neighbours, which clips the round ends away.
    const QRectF box = QRectF(rect()).adjusted(isFirst_ ? 0.5 : -radius, 0.5, isLast_ ? -0.5 : radius, -0.5);
    shape.addRoundedRect(box, radius, radius);
    const QColor ground = isChecked()    ? theme_.color("accent.bg")
                          : underMouse() ? theme_.color("hover")
                                         : theme_.color("panel");
    painter.setPen(line);
    painter.setBrush(ground);
    painter.drawPath(shape);
    if (!isFirst_) {
      painter.drawLine(QPointF(0.0, 1.0), QPointF(0.0, height() - 1.0));
    }
    paintText(painter);
    if (hasFocus()) {
      painter.setPen(QPen(theme_.color("accent"), 2.0));
      painter.setBrush(Qt::NoBrush);
      painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
  }

  void enterEvent(QEnterEvent* event) override {
    QAbstractButton::enterEvent(event);
    update();
  }
  void leaveEvent(QEvent* event) override {
    QAbstractButton::leaveEvent(event);
    update();
  }

 private:
  void paintText(QPainter& painter) const {
    QRect rest = rect().adjusted(padding, 0, -padding, 0);
    painter.setPen(theme_.color(!isEnabled() ? "disabled" : isChecked() ? "accent" : "text"));
    painter.drawText(rest, Qt::AlignVCenter | (count_.isEmpty() ? Qt::AlignHCenter : Qt::AlignLeft), text());
    if (!count_.isEmpty()) {
      if (!isChecked()) {
        painter.setPen(theme_.color("text.3"));
      }
      painter.drawText(rest, Qt::AlignVCenter | Qt::AlignRight, count_);
    }
  }

  const Theme& theme_;
  QString count_;
  bool isFirst_ = false;
  bool isLast_ = false;
};

}  // namespace

Segments::Segments(const Theme& theme, QWidget* parent)
    : QFrame(parent), theme_(theme), group_(new QButtonGroup(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(group_, &QButtonGroup::idClicked, this, &Segments::chosen);
  connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void Segments::setSegments(const std::vector<Segment>& segments) {
  const int before = current();
  for (QAbstractButton* button : group_->buttons()) {
    group_->removeButton(button);
    delete button;
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    auto* button = new SegmentButton(theme_, segments[i], this);
    button->setEnds(i == 0, i + 1 == segments.size());
    group_->addButton(button, static_cast<int>(i));
    layout()->addWidget(button);
  }
  setCurrent(before);
}

int Segments::count() const {
  return static_cast<int>(group_->buttons().size());
}

void Segments::setCurrent(int index) {
  if (QAbstractButton* button = group_->button(index)) {
    button->setChecked(true);
  }
}

int Segments::current() const {
  return group_->checkedId();
}

}  // namespace pbffd::ui
