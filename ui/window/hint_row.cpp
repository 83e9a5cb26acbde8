#include "ui/window/hint_row.h"

#include "ui/window/labels.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QRegularExpression>

namespace pbffd::ui {
namespace {

constexpr int leftMargin = 12;
constexpr int betweenHints = 24;
constexpr int withinHint = 6;

}  // namespace

HintRow::HintRow(QWidget* parent) : QWidget(parent), row_(new QHBoxLayout(this)) {
  row_->setContentsMargins(leftMargin, 0, 0, 0);
  row_->setSpacing(betweenHints);
  row_->addStretch();
  // It takes what the figures beside it leave, and never pushes them out of the window.
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  setMinimumWidth(1);
}

void HintRow::setHint(const QString& hint) {
  if (hint != hint_) {
    hint_ = hint;
    rebuild();
  }
}

void HintRow::rebuild() {
  qDeleteAll(hints_);
  hints_.clear();
  for (const QString& text : hint_.split("  ", Qt::SkipEmptyParts)) {
    QWidget* hint = makeHint(text, hints_.isEmpty());
    row_->insertWidget(static_cast<int>(hints_.size()), hint);
    hints_ += hint;
  }
  leaveOut();
}

QWidget* HintRow::makeHint(const QString& text, bool isFirst) {
  auto* hint = new QWidget(this);
  auto* row = new QHBoxLayout(hint);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(withinHint);
  static const QRegularExpression parts(R"(\[([^\]]+)\]|[^\[]+)");
  for (auto match = parts.globalMatch(text); match.hasNext();) {
    const auto part = match.next();
    const QString key = part.captured(1);
    if (const QString words = part.captured().trimmed(); !key.isEmpty()) {
      row->addWidget(makeLabel(key, "key"));
    } else if (!words.isEmpty()) {
      row->addWidget(makeLabel(words, isFirst ? "strong" : "label"));
    }
  }
  return hint;
}

void HintRow::leaveOut() {
  int needed = leftMargin - betweenHints;
  for (QWidget* hint : hints_) {
    needed += betweenHints + hint->sizeHint().width();
    hint->show();
  }
  for (qsizetype i = hints_.size() - 2; i > 0 && needed > width(); --i) {
    needed -= betweenHints + hints_[i]->sizeHint().width();
    hints_[i]->hide();
  }
}

void HintRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  leaveOut();
}

}  // namespace pbffd::ui
