#include "ui/window/histogram.h"

#include "ui/document/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace pbffd::ui {

Histogram::Histogram(const Theme& theme, QWidget* parent) : QWidget(parent), theme_(theme) {
  setFixedHeight(40);
  connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
}

void Histogram::setCounts(std::vector<double> counts) {
  counts_ = std::move(counts);
  update();
}

void Histogram::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(theme_.color("field.line"));
  painter.drawLine(QPointF(0, height() - 0.5), QPointF(width(), height() - 0.5));
  const double most = counts_.empty() ? 0.0 : *std::max_element(counts_.begin(), counts_.end());
  if (most <= 0.0) {
    return;
  }
  painter.setPen(Qt::NoPen);
  const double step = static_cast<double>(width()) / static_cast<double>(counts_.size());
  for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
    if (counts_[bin] <= 0.0) {
      continue;
    }
    // The root lets the few strong weights be seen beside the many weak ones.
    const double tall = std::max(1.5, (height() - 3) * std::sqrt(counts_[bin] / most));
    QColor color = theme_.color("accent");
    color.setAlphaF(
        static_cast<float>(0.45 + 0.55 * static_cast<double>(bin) / static_cast<double>(counts_.size())));
    painter.setBrush(color);
    painter.drawRoundedRect(QRectF(static_cast<double>(bin) * step, height() - 1 - tall, step - 1.5, tall), 1,
                            1);
  }
}

}  // namespace pbffd::ui
