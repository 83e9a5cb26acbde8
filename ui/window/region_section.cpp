#include "ui/window/region_section.h"

#include "ui/document/document.h"
#include "ui/window/dock.h"
#include "ui/window/labels.h"
#include "ui/window/number_field.h"
#include "ui/window/point_selection.h"
#include "ui/window/triple_field.h"

#include <QCheckBox>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace pbffd::ui {

RegionSection::RegionSection(Document& document, const Theme& theme, QWidget* parent)
    : Section(theme, tr("Region of influence"), parent),
      document_(document),
      semiAxes_(new TripleField(document, theme, {tr("Semi-axes"), {"a", "b", "c"}})),
      uniform_(makeIconButton(theme, "link", tr("Scale all three together"))),
      range_(makeLabel({}, "label")),
      enabled_(new QCheckBox) {
  setToolTip(tr("ROI: where this point moves the mesh, an ellipsoid"));
  uniform_->setProperty("role", "flat");
  uniform_->setCheckable(true);
  for (int axis = 0; axis < 3; ++axis) {
    semiAxes_->field(axis).setRange(1e-12, 1e300);
  }
  semiAxes_->setEditMaker([this](int axis, const NumberInput& input) {
    return regionEdit(committedSelection(document_), axis, input, uniform_->isChecked());
  });
  connect(semiAxes_, &TripleField::settled, this, &RegionSection::settled);
  body()->addWidget(semiAxes_);
  auto* row = labelledRow(tr("Range"), {range_});
  row->addStretch();
  row->addWidget(uniform_);
  body()->addLayout(row);
  enabled_->setAccessibleName(tr("Enabled"));
  connect(enabled_, &QCheckBox::clicked, this, [this] {
    const bool isOn = enabled_->checkState() != Qt::Unchecked;
    document_.perform(Enable{{document_.selection().level(), document_.selection().points()}, isOn});
    Q_EMIT settled();
  });
  row = labelledRow(tr("Enabled"), {enabled_});
  row->addStretch();
  body()->addLayout(row);
}

void RegionSection::show(const PointsOfLevel& points) {
  const double diagonal = document_.shown().mesh->diagonal();
  const int decimals = decimalsFor(diagonal);
  semiAxes_->setDecimals(decimals);
  semiAxes_->setStep(stepFor(diagonal));
  semiAxes_->setStandsForMany(points.points.size() > 1);
  std::array<SharedValue, 3> values;
  double smallest = 1e300;
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> lengths;
    for (const ControlPoint* point : points.points) {
      lengths.push_back(point->rest.axes.col(axis).norm());
    }
    const auto [low, high] = std::minmax_element(lengths.begin(), lengths.end());
    smallest = std::min(smallest, *low);
    largest = std::max(largest, *high);
    values[static_cast<std::size_t>(axis)] = shared(lengths);
  }
  semiAxes_->showValues(values, false);
  const QString low = NumberField::formatted(smallest, decimals);
  const QString high = NumberField::formatted(largest, decimals);
  range_->setText(low == high ? tr("%1 units").arg(low) : tr("%1 to %2 units").arg(low, high));
  showEnabled(points);
}

void RegionSection::showEnabled(const PointsOfLevel& points) {
  const auto count = static_cast<qint64>(points.points.size());
  const auto enabled = static_cast<qint64>(std::count_if(
      points.points.begin(), points.points.end(), [](const ControlPoint* point) { return point->enabled; }));
  const QSignalBlocker quiet(enabled_);
  enabled_->setTristate(enabled != 0 && enabled != count);
  enabled_->setCheckState(enabled == 0 ? Qt::Unchecked : enabled == count ? Qt::Checked : Qt::PartiallyChecked);
  enabled_->setText(count == 1         ? QString()
                    : enabled == count ? tr("all %1").arg(counted(count))
                                       : tr("%1 of %2").arg(counted(enabled), counted(count)));
}

}  // namespace pbffd::ui
