#include "ui/window/placement_more.h"

#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/window/labels.h"
#include "ui/window/number_field.h"
#include "ui/window/section.h"

#include <QComboBox>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace pbffd::ui {
namespace {

QComboBox* makeCombo(const QStringList& items, const QString& name) {
  auto* combo = new QComboBox;
  combo->addItems(items);
  combo->setAccessibleName(name);
  combo->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  return combo;
}

}  // namespace

PlacementMore::PlacementMore(const Theme& theme, QWidget* parent)
    : QWidget(parent), theme_(theme), fold_(new QPushButton(tr("More"))), rows_(new QWidget) {
  makeFields();
  auto* paper = new QPushButton(tr("Paper settings"));
  paper->setToolTip(tr("Gaussian kernel, the paper's master, radius 1.5, offset 10 %, regions reach all"));
  connect(paper, &QPushButton::clicked, this, &PlacementMore::paperAsked);
  auto* inner = new QVBoxLayout(rows_);
  inner->setContentsMargins(0, 4, 0, 0);
  inner->setSpacing(7);
  inner->addLayout(labelledRow(tr("Kernel"), {kernel_}));
  inner->addLayout(labelledRow(tr("Regions"), {regions_}));
  inner->addLayout(labelledRow(tr("Offset"), {offset_}));
  inner->addLayout(labelledRow(tr("Exterior"), {exterior_}));
  inner->addLayout(labelledRow(tr("Sites"), {sites_}));
  inner->addLayout(labelledRow(tr("Master"), {master_}));
  inner->addLayout(labelledRow(tr("Seed"), {seed_}));
  auto* paperRow = labelledRow({}, {paper});
  paperRow->addStretch();
  inner->addLayout(paperRow);
  fold_->setProperty("role", "fold");
  fold_->setCheckable(true);
  fold_->setIconSize({14, 14});
  connect(fold_, &QPushButton::toggled, this, &PlacementMore::setOpen);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(fold_, 0, Qt::AlignLeft);
  column->addWidget(rows_);
  setOpen(false);
}

NumberField* PlacementMore::makeField(const QString& name, const QString& suffix, int decimals) {
  auto* field = new NumberField(theme_, {{}, {}, suffix});
  field->setAccessibleName(name);
  field->setDecimals(decimals);
  field->setScrubbable(false);
  return field;
}

void PlacementMore::makeFields() {
  kernel_ = makeCombo({tr("Smooth"), tr("Wendland"), tr("Gaussian")}, tr("Kernel"));
  regions_ = makeCombo({tr("Spheres"), tr("Ellipsoids")}, tr("Shape of the regions"));
  regions_->setToolTip(
      tr("Ellipsoids are long where points are sparse; a merged point takes the least one\n"
         "that encloses the two it stands for"));
  offset_ = makeField(tr("Offset of exterior points, percent of the size"), tr("% of size"), 1);
  offset_->setRange(0.0, 100.0);
  offset_->setStep(0.5);
  exterior_ = makeField(tr("Exterior points, percent of all"), tr("% of points"), 0);
  exterior_->setRange(0.0, 100.0);
  exterior_->setStep(5.0);
  sites_ = makeCombo({tr("Automatic"), tr("Every vertex")}, tr("Voronoi sites"));
  sites_->setToolTip(tr("The vertices that the Voronoi diagram is made of"));
  master_ = makeField(tr("Value of the master control point"), {}, 3);
  master_->setToolTip(tr("Holds what no control point reaches"));
  master_->setRange(0.0, 1e6);
  seed_ = makeField(tr("Seed"), {}, 0);
  seed_->setRange(0.0, 4294967295.0);
  seed_->setStep(1.0);
  for (NumberField* field : {offset_, exterior_, seed_}) {
    connectField(field);
  }
  connect(regions_, &QComboBox::activated, this, [this] { Q_EMIT changed(true); });
  connect(sites_, &QComboBox::activated, this, [this] { Q_EMIT changed(true); });
  connect(kernel_, &QComboBox::activated, this,
          [this](int index) { Q_EMIT kernelChosen(static_cast<Kernel>(index)); });
  connect(master_, &NumberField::entered, this,
          [this](const NumberInput& input) { Q_EMIT masterEntered(input.appliedTo(master_->value())); });
  connect(master_, &NumberField::nudged, this,
          [this](double delta) { Q_EMIT masterEntered(std::max(0.0, master_->value() + delta)); });
}

void PlacementMore::connectField(NumberField* field) {
  connect(field, &NumberField::entered, this, [this, field](const NumberInput& input) {
    field->setValue(input.appliedTo(field->value()));
    Q_EMIT changed(true);
  });
  connect(field, &NumberField::nudged, this, [this, field](double delta) {
    field->setValue(field->value() + delta);
    Q_EMIT changed(false);
  });
}

void PlacementMore::setOpen(bool open) {
  fold_->setChecked(open);
  fold_->setIcon(makeIcon(theme_, open ? "chevron-down" : "chevron-right", {"text.3", "text.3"}));
  rows_->setVisible(open);
}

void PlacementMore::show(const PlacementOptions& options) {
  kernel_->setCurrentIndex(static_cast<int>(options.basis.kernel));
  regions_->setCurrentIndex(static_cast<int>(options.regions));
  offset_->setValue(options.offset * 100.0);
  exterior_->setValue(options.exteriorShare * 100.0);
  master_->setValue(options.master);
  seed_->setValue(options.seed);
  // A number of sites of its own comes from a file or the command line: it is shown and kept.
  while (sites_->count() > 2) {
    sites_->removeItem(2);
  }
  if (options.sites && *options.sites > 0) {
    sites_->addItem(counted(*options.sites));
    sites_->setCurrentIndex(2);
  } else {
    sites_->setCurrentIndex(options.sites ? 1 : 0);
  }
}

PlacementOptions PlacementMore::over(PlacementOptions options) const {
  options.regions = static_cast<RegionShape>(regions_->currentIndex());
  options.offset = offset_->value() / 100.0;
  options.exteriorShare = exterior_->value() / 100.0;
  options.seed = static_cast<unsigned>(seed_->value());
  if (sites_->currentIndex() == 0) {
    options.sites = std::nullopt;
  } else if (sites_->currentIndex() == 1) {
    options.sites = 0;
  }
  return options;
}

}  // namespace pbffd::ui
