#include "ui/window/slider_row.h"

#include "ui/window/number_field.h"
#include "ui/window/section.h"

#include <QHBoxLayout>
#include <QScopedValueRollback>
#include <QSlider>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr int positions = 1000;
constexpr int fieldWidth = 62;
constexpr int runMilliseconds = 1000;

}  // namespace

SliderRow::SliderRow(const Theme& theme, const Look& look, Scale scale, QWidget* parent)
    : QWidget(parent),
      scale_(std::move(scale)),
      slider_(new QSlider(Qt::Horizontal)),
      field_(new NumberField(theme, {{}, {}, look.suffix})) {
  slider_->setRange(0, positions);
  slider_->setSingleStep(positions / 100);
  slider_->setPageStep(positions / 10);
  slider_->setAccessibleName(look.accessibleName);
  field_->setAccessibleName(look.accessibleName);
  field_->setFixedWidth(fieldWidth);
  field_->setDecimals(look.decimals);
  field_->setRange(look.low, look.high);
  field_->setStep(look.step);
  field_->setScrubbable(false);
  run_.setSingleShot(true);
  run_.setInterval(runMilliseconds);
  connect(slider_, &QSlider::sliderPressed, this, [this] { isNewDrag_ = true; });
  connect(slider_, &QSlider::valueChanged, this, &SliderRow::slide);
  connect(field_, &NumberField::entered, this,
          [this](const NumberInput& input) { enter(input.appliedTo(field_->value()), true); });
  connect(field_, &NumberField::nudged, this, [this](double delta) { enter(field_->value() + delta, false); });
  auto* row = labelledRow(look.label, {slider_, field_});
  row->setContentsMargins(0, 0, 0, 0);
  setLayout(row);
}

double SliderRow::value() const {
  return field_->value();
}

bool SliderRow::isHeld() const {
  return slider_->isSliderDown();
}

void SliderRow::setValue(double value) {
  const QScopedValueRollback guard(isSetting_, true);
  field_->setValue(value);
  slider_->setValue(static_cast<int>(std::lround(std::clamp(scale_.shareOf(value), 0.0, 1.0) * positions)));
}

void SliderRow::slide(int position) {
  if (isSetting_) {
    return;
  }
  field_->setValue(scale_.valueAt(static_cast<double>(position) / positions));
  announce(isHeld() ? std::exchange(isNewDrag_, false) : !run_.isActive());
}

void SliderRow::enter(double value, bool isTyped) {
  setValue(value);
  announce(isTyped || !run_.isActive());
}

void SliderRow::announce(bool startsRun) {
  run_.start();
  Q_EMIT changed(startsRun);
}

}  // namespace pbffd::ui
