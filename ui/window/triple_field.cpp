#include "ui/window/triple_field.h"

#include "ui/document/document.h"
#include "ui/window/labels.h"
#include "ui/window/number_field.h"
#include "ui/window/section.h"

#include <QDateTime>
#include <QVBoxLayout>

#include <utility>

namespace pbffd::ui {
namespace {

constexpr qint64 nudgeRunMilliseconds = 1000;
/// A scrub is shown live while an update takes no longer; else its end alone is.
constexpr double liveMilliseconds = 30.0;

}  // namespace

TripleField::TripleField(Document& document, const Theme& theme, const Look& look, QWidget* parent)
    : QWidget(parent), document_(document), reason_(makeLabel({}, "bad")) {
  static const char* const axes[] = {"X", "Y", "Z"};
  static const char* const tokens[] = {"axis.x", "axis.y", "axis.z"};
  QList<QWidget*> widgets;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const QString& prefix = look.prefixes[axis];
    fields_[axis] = new NumberField(theme, {prefix.isEmpty() ? tokens[axis] : "", prefix, look.suffix});
    fields_[axis]->setAccessibleName(look.label + " " + (prefix.isEmpty() ? QString(axes[axis]) : prefix));
    connectField(static_cast<int>(axis));
    widgets += fields_[axis];
  }
  reason_->setWordWrap(true);
  reason_->hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(3);
  column->addLayout(labelledRow(look.label, widgets));
  column->addWidget(reason_);
}

void TripleField::connectField(int axis) {
  NumberField* field = fields_[static_cast<std::size_t>(axis)];
  connect(field, &NumberField::entered, this, [this, axis](const NumberInput& input) {
    if (const auto edit = maker_(axis, input)) {
      document_.perform(*edit);
    }
    Q_EMIT settled();
  });
  connect(field, &NumberField::nudged, this, [this, axis](double delta) { nudge(axis, delta); });
  connect(field, &NumberField::scrubbed, this, [this, axis](double delta) { scrub(axis, delta); });
  connect(field, &NumberField::scrubEnded, this, &TripleField::endScrub);
  connect(field, &NumberField::rejected, this, &TripleField::showReason);
}

std::optional<Edit> TripleField::make(int axis, NumberInput::Kind kind, double value) const {
  return maker_(axis, {kind, value});
}

/// Steps one right after the other are one entry of the history.
void TripleField::nudge(int axis, double delta) {
  const qint64 now = QDateTime::currentMSecsSinceEpoch();
  if (now - std::exchange(lastNudge_, now) > nudgeRunMilliseconds) {
    nudgeKey_ = document_.newMergeKey();
  }
  if (const auto edit = make(axis, NumberInput::Kind::add, delta)) {
    document_.perform(*edit, {nudgeKey_});
  }
}

/// The edit is made of the committed points, so that each step of a scrub starts from there.
void TripleField::scrub(int axis, double delta) {
  waitingScrub_ = make(axis, NumberInput::Kind::add, delta);
  if (waitingScrub_ && document_.lastMilliseconds() < liveMilliseconds && document_.preview(*waitingScrub_)) {
    waitingScrub_.reset();
  }
}

void TripleField::endScrub(bool keep) {
  const std::optional<Edit> waiting = std::exchange(waitingScrub_, std::nullopt);
  if (!keep) {
    document_.cancelPreview();
  } else if (waiting) {
    document_.perform(*waiting);
  } else {
    document_.commitPreview();
  }
  Q_EMIT settled();
}

void TripleField::showReason(const QString& reason) {
  reason_->setText(reason);
  reason_->setVisible(!reason.isEmpty());
}

void TripleField::setDecimals(int decimals) {
  for (NumberField* field : fields_) {
    field->setDecimals(decimals);
  }
}

void TripleField::setStep(double step) {
  for (NumberField* field : fields_) {
    field->setStep(step);
  }
}

void TripleField::setStandsForMany(bool many) {
  for (NumberField* field : fields_) {
    field->setStandsForMany(many);
  }
}

void TripleField::showValues(const std::array<SharedValue, 3>& values, bool mixedAsMiddle) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (values[axis].isMixed && !mixedAsMiddle) {
      fields_[axis]->setMixed(values[axis].middle);
    } else {
      fields_[axis]->setValue(values[axis].middle);
    }
  }
}

}  // namespace pbffd::ui
