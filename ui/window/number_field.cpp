#include "ui/window/number_field.h"

#include "ui/document/theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pbffd::ui {
namespace {

constexpr int leastWidth = 48;
/// What QLineEdit keeps free at each side of its text, beside the text margins.
constexpr int sideMargin = 2;
constexpr double dragThreshold = 4.0;
constexpr double fineShare = 0.1;

}  // namespace

NumberField::NumberField(const Theme& theme, const Look& look, QWidget* parent)
    : QLineEdit(parent), theme_(theme), look_(look) {
  // A press may begin a scrub; a click gives the focus.
  setFocusPolicy(Qt::TabFocus);
  setFixedHeight(26);
  // Three in a row fit the narrowest dock, whatever is drawn beside the numbers.
  setMinimumWidth(leastWidth);
  const int left = (look.barToken.isEmpty() ? 0 : 6) +
                   (look.prefix.isEmpty() ? 0 : fontMetrics().horizontalAdvance(look.prefix) + 4);
  const int right = look.suffix.isEmpty() ? 0 : fontMetrics().horizontalAdvance(look.suffix) + 4;
  setTextMargins(left, 0, right, 0);
  setCursor(Qt::SizeHorCursor);
  connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

QString NumberField::formatted(double value, int decimals) {
  QString text = QString::number(value, 'f', decimals);
  if (text.toDouble() == 0.0 && text.startsWith(u'-')) {
    text.remove(0, 1);
  }
  return text.replace(u'-', QChar(0x2212));
}

void NumberField::setRange(double low, double high) {
  low_ = low;
  high_ = high;
}

void NumberField::setValue(double value) {
  state_ = State::single;
  value_ = value;
  showValue();
}

void NumberField::setMixed(double middle) {
  state_ = State::mixed;
  value_ = middle;
  showValue();
}

void NumberField::setBlank() {
  state_ = State::blank;
  showValue();
}

/// The number with as many of its decimals as are seen whole: one that is cut off reads as another.
QString NumberField::fitting() const {
  QStyleOptionFrame option;
  initStyleOption(&option);
  const QRect contents = style()->subElementRect(QStyle::SE_LineEditContents, &option, this);
  const int room = contents.marginsRemoved(textMargins()).width() - 2 * sideMargin;
  int decimals = decimals_;
  while (decimals > 0 && fontMetrics().horizontalAdvance(formatted(value_, decimals)) > room) {
    --decimals;
  }
  return formatted(value_, decimals);
}

/// What is being typed is not overwritten by a change elsewhere.
void NumberField::showValue() {
  if (hasFocus() && (isModified() || isBad_)) {
    return;
  }
  const QString text = state_ == State::single  ? fitting()
                       : state_ == State::mixed ? tr("mixed")
                                                : QString();
  if (text != this->text()) {
    setText(text);
    setCursorPosition(0);
    if (hasFocus()) {
      selectAll();
    }
  }
}

void NumberField::resizeEvent(QResizeEvent* event) {
  QLineEdit::resizeEvent(event);
  showValue();
}

bool NumberField::isInRange(const NumberInput& input) const {
  const double result = input.appliedTo(value_);
  return std::isfinite(result) && result >= low_ && result <= high_;
}

void NumberField::accept() {
  if (!isModified()) {
    return;
  }
  const auto input = parseNumberInput(text(), isForMany_);
  if (!input) {
    return setBad(tr("\"%1\" is not a number or a sum.").arg(text()));
  }
  if (!isInRange(*input)) {
    return setBad(high_ < 1e300
                      ? tr("Give a number from %1 to %2.").arg(formatted(low_, 0), formatted(high_, 0))
                      : tr("Give a number above %1.").arg(formatted(low_, 0)));
  }
  setBad({});
  setModified(false);
  Q_EMIT entered(*input);
  showValue();
}

void NumberField::setBad(const QString& reason) {
  if (isBad_ != !reason.isEmpty()) {
    isBad_ = !reason.isEmpty();
    setProperty("bad", isBad_);
    style()->unpolish(this);
    style()->polish(this);
  }
  setToolTip(reason);
  Q_EMIT rejected(reason);
}

void NumberField::paintEvent(QPaintEvent* event) {
  QLineEdit::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  int left = 7;
  if (!look_.barToken.isEmpty()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme_.color(look_.barToken));
    painter.drawRoundedRect(QRectF(6, height() / 2.0 - 6, 2.5, 12), 1.2, 1.2);
    left += 8;
  }
  painter.setPen(theme_.color("text.3"));
  if (!look_.prefix.isEmpty()) {
    painter.drawText(rect().adjusted(left, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, look_.prefix);
  }
  if (!look_.suffix.isEmpty()) {
    painter.drawText(rect().adjusted(0, 0, -8, 0), Qt::AlignRight | Qt::AlignVCenter, look_.suffix);
  }
}

void NumberField::mousePressEvent(QMouseEvent* event) {
  if (hasFocus() || event->button() != Qt::LeftButton) {
    return QLineEdit::mousePressEvent(event);
  }
  scrub_ = Scrub{event->globalPosition().x(), value_, false};
}

void NumberField::mouseMoveEvent(QMouseEvent* event) {
  if (!scrub_) {
    return QLineEdit::mouseMoveEvent(event);
  }
  const double pixels = event->globalPosition().x() - scrub_->pressedAt;
  const bool canScrub = isScrubbable_ && state_ != State::blank && isEnabled();
  if (!scrub_->isMoving && (!canScrub || std::abs(pixels) < dragThreshold)) {
    return;
  }
  scrub_->isMoving = true;
  // Escape has to reach this field to take the scrub back.
  grabKeyboard();
  const double share = event->modifiers() & Qt::ShiftModifier ? fineShare : 1.0;
  const double start = scrub_->startValue;
  Q_EMIT scrubbed(std::clamp(start + pixels * step_ * share, low_, high_) - start);
}

void NumberField::mouseReleaseEvent(QMouseEvent* event) {
  if (!scrub_) {
    return QLineEdit::mouseReleaseEvent(event);
  }
  if (scrub_->isMoving) {
    return endScrub(true);
  }
  scrub_.reset();
  setFocus(Qt::MouseFocusReason);
  selectAll();
}

void NumberField::endScrub(bool keep) {
  releaseKeyboard();
  scrub_.reset();
  Q_EMIT scrubEnded(keep);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  if (scrub_ && scrub_->isMoving) {
    if (event->key() == Qt::Key_Escape) {
      endScrub(false);
    }
    return;
  }
  const double share = event->modifiers() & Qt::ShiftModifier ? fineShare : 1.0;
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      accept();
      if (!isBad_) {
        selectAll();
      }
      return;
    case Qt::Key_Escape:
      setBad({});
      setModified(false);
      showValue();
      clearFocus();
      return;
    case Qt::Key_Up:
    case Qt::Key_Down:
      accept();
      if (state_ != State::blank && !isBad_) {
        const double delta = (event->key() == Qt::Key_Up ? step_ : -step_) * share;
        Q_EMIT nudged(std::clamp(value_ + delta, low_, high_) - value_);
      }
      return;
    default:
      QLineEdit::keyPressEvent(event);
  }
}

void NumberField::wheelEvent(QWheelEvent* event) {
  if (!hasFocus() || state_ == State::blank) {
    return event->ignore();
  }
  const double delta = event->angleDelta().y() > 0 ? step_ : -step_;
  Q_EMIT nudged(std::clamp(value_ + delta, low_, high_) - value_);
  event->accept();
}

void NumberField::focusInEvent(QFocusEvent* event) {
  setCursor(Qt::IBeamCursor);
  QLineEdit::focusInEvent(event);
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  accept();
  // A value that was refused is dropped: the old one stays in force.
  setBad({});
  setModified(false);
  setCursor(Qt::SizeHorCursor);
  QLineEdit::focusOutEvent(event);
  showValue();
}

}  // namespace pbffd::ui
