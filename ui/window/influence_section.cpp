#include "ui/window/influence_section.h"

#include "ui/document/document.h"
#include "ui/models/influence.h"
#include "ui/window/histogram.h"
#include "ui/window/labels.h"

#include <QVBoxLayout>

namespace pbffd::ui {

InfluenceSection::InfluenceSection(Document& document, const Theme& theme, QWidget* parent)
    : Section(theme, tr("Influence"), parent),
      document_(document),
      histogram_(new Histogram(theme)),
      reachedName_(makeLabel({}, "label")) {
  histogram_->setAccessibleName(tr("Weights of the selection where it reaches"));
  histogram_->setToolTip(tr("How much of what is reached has which weight of the selection"));
  body()->addWidget(histogram_);
  auto* scale = new QHBoxLayout;
  scale->addWidget(makeLabel(tr("weight 0"), "caption"));
  scale->addStretch();
  scale->addWidget(makeLabel("1", "caption"));
  body()->addLayout(scale);
  reached_ = addRow(reachedName_);
  strongest_ = addRow(makeLabel(tr("Strongest weight"), "label"));
  timer_.setSingleShot(true);
  timer_.setInterval(0);
  connect(&timer_, &QTimer::timeout, this, &InfluenceSection::refresh);
}

QLabel* InfluenceSection::addRow(QLabel* name) {
  QLabel* value = makeLabel({}, "value");
  auto* row = new QHBoxLayout;
  row->addWidget(name);
  row->addStretch();
  row->addWidget(value);
  body()->addLayout(row);
  return value;
}

void InfluenceSection::refreshLater() {
  if (!document_.isPreviewing()) {
    timer_.start();
  }
}

void InfluenceSection::refresh() {
  const auto& levels = document_.shown().controls.levels;
  const auto place = static_cast<std::size_t>(document_.editLevel());
  const auto& points = document_.selection().points();
  if (!document_.isOpen() || points.empty() || place >= levels.size()) {
    return;
  }
  const bool isFinest = place + 1 == levels.size();
  const Influence influence = isFinest
                                  ? influenceOnMesh(*document_.parameterization(), levels[place], points)
                                  : influenceOnPoints((*document_.bindings())[place], levels[place], points);
  histogram_->setCounts({influence.histogram.begin(), influence.histogram.end()});
  reachedName_->setText(isFinest ? tr("Vertices reached") : tr("Points of level %1 reached").arg(place + 2));
  reached_->setText(tr("%1 of %2").arg(counted(influence.reached), counted(influence.total)));
  const QString weight = QString::number(influence.strongest, 'f', 2);
  strongest_->setText(influence.strongestPoint == 0 ? tr("none")
                      : points.size() == 1          ? weight
                                           : tr("%1 (point %2)").arg(weight).arg(influence.strongestPoint));
}

}  // namespace pbffd::ui
