#include "ui/window/placement_panel.h"

#include "ui/document/document.h"
#include "ui/document/icons.h"
#include "ui/document/job_runner.h"
#include "ui/document/theme.h"
#include "ui/window/labels.h"
#include "ui/window/number_field.h"
#include "ui/window/section.h"
#include "ui/window/segments.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace pbffd::ui {
namespace {

constexpr int sliderSteps = 1000;
constexpr double fewestPoints = 20.0;
constexpr double mostSliderPoints = 2000.0;
constexpr double mostPoints = 20000.0;
constexpr double leastRadius = 1.0;
constexpr double mostRadius = 3.0;
constexpr int fieldWidth = 62;
constexpr int highestLevelCount = 5;
/// Arrow keys on a slider within this time are one entry of the history.
constexpr int runMilliseconds = 1000;

int pointsAt(int position) {
  const double share = static_cast<double>(position) / sliderSteps;
  const double points = fewestPoints * std::pow(mostSliderPoints / fewestPoints, share);
  // Round figures where one point more or less cannot be aimed at.
  const double grain = points < 200 ? 1.0 : points < 500 ? 5.0 : 10.0;
  return static_cast<int>(std::lround(points / grain) * grain);
}

int positionOf(int points) {
  const double share =
      std::log(std::max(points / fewestPoints, 1e-9)) / std::log(mostSliderPoints / fewestPoints);
  return std::clamp(static_cast<int>(std::lround(share * sliderSteps)), 0, sliderSteps);
}

QSlider* makeSlider(const QString& name) {
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setRange(0, sliderSteps);
  slider->setSingleStep(10);
  slider->setPageStep(100);
  slider->setAccessibleName(name);
  return slider;
}

QComboBox* makeCombo(const QStringList& items, const QString& name) {
  auto* combo = new QComboBox;
  combo->addItems(items);
  combo->setAccessibleName(name);
  combo->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  return combo;
}

}  // namespace

PlacementPanel::PlacementPanel(Document& document, const Theme& theme, QWidget* parent)
    : QScrollArea(parent), document_(document), theme_(theme) {
  setAccessibleName(tr("Placement"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);
  auto* content = new QWidget;
  content->setProperty("role", "dock");
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(7);
  column->addLayout(makePointsRow());
  levels_ = new Segments(theme);
  std::vector<Segments::Segment> counts;
  for (int level = 1; level <= highestLevelCount; ++level) {
    counts.push_back({QString::number(level), {}, tr("%n level(s)", nullptr, level)});
  }
  levels_->setSegments(counts);
  levels_->setAccessibleName(tr("Levels"));
  auto* levelRow = labelledRow(tr("Levels"), {levels_});
  levelRow->addStretch();
  column->addLayout(levelRow);
  column->addLayout(makeRadiusRow());
  surface_ = makeCombo({tr("Automatic"), tr("Closed"), tr("Open")}, tr("Surface"));
  column->addLayout(labelledRow(tr("Surface"), {surface_}));
  column->addWidget(makeMore());
  column->addLayout(makeFooter());
  column->addStretch();
  setWidget(content);

  connect(levels_, &Segments::chosen, this, [this] { change(0); });
  connect(surface_, &QComboBox::activated, this, [this] { change(0); });
  connectMore();
  keyTimer_.setSingleShot(true);
  keyTimer_.setInterval(runMilliseconds);
  connect(&keyTimer_, &QTimer::timeout, this, [this] { scrubKey_ = 0; });
  connect(&document, &Document::opened, this, &PlacementPanel::load);
  connect(&document, &Document::changed, this, &PlacementPanel::follow);
  connect(&document, &Document::placed, this, &PlacementPanel::showFooter);
  connect(&document.jobs(), &JobRunner::started, this, &PlacementPanel::showFooter);
  connect(&document.jobs(), &JobRunner::finished, this, &PlacementPanel::showFooter);
  load();
}

QLayout* PlacementPanel::makePointsRow() {
  points_ = makeSlider(tr("Number of control points"));
  pointsField_ = new NumberField(theme_, {});
  pointsField_->setAccessibleName(tr("Number of control points"));
  pointsField_->setFixedWidth(fieldWidth);
  pointsField_->setDecimals(0);
  pointsField_->setRange(1.0, mostPoints);
  pointsField_->setStep(1.0);
  pointsField_->setScrubbable(false);
  connect(points_, &QSlider::valueChanged, this, [this](int position) {
    if (!isLoading_) {
      pointsField_->setValue(pointsAt(position));
      change(scrubKey(*points_));
    }
  });
  connect(points_, &QSlider::sliderPressed, this, [this] { scrubKey_ = document_.newMergeKey(); });
  const auto typed = [this](double points, int mergeKey) {
    {
      const QScopedValueRollback guard(isLoading_, true);
      pointsField_->setValue(points);
      points_->setValue(positionOf(static_cast<int>(points)));
    }
    change(mergeKey);
  };
  connect(pointsField_, &NumberField::entered, this, [this, typed](const NumberInput& input) {
    typed(std::round(input.appliedTo(pointsField_->value())), 0);
  });
  connect(pointsField_, &NumberField::nudged, this,
          [this, typed](double delta) { typed(pointsField_->value() + delta, scrubKey(*points_)); });
  return labelledRow(tr("Points"), {points_, pointsField_});
}

QLayout* PlacementPanel::makeRadiusRow() {
  radius_ = makeSlider(tr("Radius of the regions"));
  radius_->setToolTip(tr("Radius of each region, in distances to the nearest control point"));
  radiusField_ = new NumberField(theme_, {{}, {}, QString(QChar(0x00d7))});
  radiusField_->setAccessibleName(tr("Radius of the regions, times the distance to the nearest point"));
  radiusField_->setFixedWidth(fieldWidth);
  radiusField_->setDecimals(2);
  radiusField_->setRange(0.1, 20.0);
  radiusField_->setStep(0.05);
  radiusField_->setScrubbable(false);
  connect(radius_, &QSlider::valueChanged, this, [this](int position) {
    if (!isLoading_) {
      const double factor = leastRadius + (mostRadius - leastRadius) * position / sliderSteps;
      radiusField_->setValue(std::round(factor * 20.0) / 20.0);
      change(scrubKey(*radius_));
    }
  });
  connect(radius_, &QSlider::sliderPressed, this, [this] { scrubKey_ = document_.newMergeKey(); });
  const auto typed = [this](double factor, int mergeKey) {
    {
      const QScopedValueRollback guard(isLoading_, true);
      radiusField_->setValue(factor);
      const double share = (factor - leastRadius) / (mostRadius - leastRadius);
      radius_->setValue(static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * sliderSteps)));
    }
    change(mergeKey);
  };
  connect(radiusField_, &NumberField::entered, this,
          [this, typed](const NumberInput& input) { typed(input.appliedTo(radiusField_->value()), 0); });
  connect(radiusField_, &NumberField::nudged, this,
          [this, typed](double delta) { typed(radiusField_->value() + delta, scrubKey(*radius_)); });
  return labelledRow(tr("Radius"), {radius_, radiusField_});
}

QWidget* PlacementPanel::makeMore() {
  const auto field = [&](const QString& name, const QString& suffix, int decimals) {
    auto* made = new NumberField(theme_, {{}, {}, suffix});
    made->setAccessibleName(name);
    made->setDecimals(decimals);
    made->setScrubbable(false);
    return made;
  };
  kernel_ = makeCombo({tr("Smooth"), tr("Wendland"), tr("Gaussian")}, tr("Kernel"));
  offset_ = field(tr("Offset of exterior points, percent of the size"), tr("% of size"), 1);
  offset_->setRange(0.0, 100.0);
  offset_->setStep(0.5);
  exterior_ = field(tr("Exterior points, percent of all"), tr("% of points"), 0);
  exterior_->setRange(0.0, 100.0);
  exterior_->setStep(5.0);
  sites_ = makeCombo({tr("Automatic"), tr("Every vertex")}, tr("Voronoi sites"));
  master_ = field(tr("Value of the master control point"), {}, 3);
  master_->setToolTip(tr("Holds what no control point reaches"));
  master_->setRange(0.0, 1e6);
  seed_ = field(tr("Seed"), {}, 0);
  seed_->setRange(0.0, 4294967295.0);
  seed_->setStep(1.0);
  paper_ = new QPushButton(tr("Paper settings"));
  paper_->setToolTip(tr("Gaussian kernel, the paper's master, radius 1.5, offset 10 %, regions reach all"));

  auto* fold = new QPushButton(tr("More"));
  fold->setProperty("role", "fold");
  fold->setCheckable(true);
  fold->setIconSize({14, 14});
  auto* rows = new QWidget;
  auto* inner = new QVBoxLayout(rows);
  inner->setContentsMargins(0, 4, 0, 0);
  inner->setSpacing(7);
  inner->addLayout(labelledRow(tr("Kernel"), {kernel_}));
  inner->addLayout(labelledRow(tr("Offset"), {offset_}));
  inner->addLayout(labelledRow(tr("Exterior"), {exterior_}));
  inner->addLayout(labelledRow(tr("Sites"), {sites_}));
  inner->addLayout(labelledRow(tr("Master"), {master_}));
  inner->addLayout(labelledRow(tr("Seed"), {seed_}));
  auto* paperRow = labelledRow({}, {paper_});
  paperRow->addStretch();
  inner->addLayout(paperRow);
  const auto open = [this, fold, rows](bool isOpen) {
    fold->setIcon(makeIcon(theme_, isOpen ? "chevron-down" : "chevron-right", {"text.3", "text.3"}));
    rows->setVisible(isOpen);
  };
  connect(fold, &QPushButton::toggled, this, open);
  open(false);
  auto* more = new QWidget;
  auto* column = new QVBoxLayout(more);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(fold, 0, Qt::AlignLeft);
  column->addWidget(rows);
  return more;
}

void PlacementPanel::connectMore() {
  for (NumberField* field : {offset_, exterior_, seed_}) {
    connect(field, &NumberField::entered, this, [this, field](const NumberInput& input) {
      field->setValue(input.appliedTo(field->value()));
      change(0);
    });
    connect(field, &NumberField::nudged, this, [this, field](double delta) {
      field->setValue(field->value() + delta);
      change(scrubKey(*points_));
    });
  }
  connect(sites_, &QComboBox::activated, this, [this] { change(0); });
  // Kernel and master need no other points: they are edits of their own.
  connect(kernel_, &QComboBox::activated, this, [this](int index) {
    document_.perform(SetKernel{{static_cast<Kernel>(index), base_.basis.sigma}});
  });
  connect(master_, &NumberField::entered, this, [this](const NumberInput& input) {
    document_.perform(SetMaster{input.appliedTo(master_->value()), MasterMode::constant});
  });
  connect(master_, &NumberField::nudged, this, [this](double delta) {
    document_.perform(SetMaster{std::max(0.0, master_->value() + delta), MasterMode::constant},
                      {scrubKey(*points_)});
  });
  connect(paper_, &QPushButton::clicked, this, [this] {
    PlacementOptions paper = paperOptions();
    paper.points = options().points;
    paper.levels = options().levels;
    show(paper);
    change(0);
  });
}

QLayout* PlacementPanel::makeFooter() {
  again_ = new QPushButton(tr("Place again"));
  connect(again_, &QPushButton::clicked, this, &PlacementPanel::placeAgain);
  keepEdits_ = new QCheckBox(tr("Keep edits"));
  keepEdits_->setToolTip(tr("New points take over the deformation of their places"));
  keepEdits_->setChecked(true);
  footer_ = makeLabel({}, "quiet");
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 6, 0, 0);
  row->setSpacing(10);
  row->addWidget(again_);
  row->addWidget(keepEdits_);
  row->addStretch();
  row->addWidget(footer_);
  return row;
}

/// The key under which steps of a slider merge: one drag, or keys and wheel turns one right after the other.
int PlacementPanel::scrubKey(const QSlider& slider) {
  if (!slider.isSliderDown()) {
    if (!keyTimer_.isActive()) {
      scrubKey_ = document_.newMergeKey();
    }
    keyTimer_.start();
  }
  return scrubKey_;
}

PlacementOptions PlacementPanel::options() const {
  PlacementOptions options = base_;
  options.points = static_cast<int>(std::lround(pointsField_->value()));
  options.levels = std::max(levels_->current(), 0) + 1;
  options.radiusFactor = radiusField_->value();
  options.surface = static_cast<Surface>(surface_->currentIndex());
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

void PlacementPanel::show(const PlacementOptions& options) {
  const QScopedValueRollback guard(isLoading_, true);
  base_ = options;
  points_->setValue(positionOf(options.points));
  pointsField_->setValue(options.points);
  levels_->setCurrent(std::clamp(options.levels, 1, highestLevelCount) - 1);
  radiusField_->setValue(options.radiusFactor);
  const double share = (options.radiusFactor - leastRadius) / (mostRadius - leastRadius);
  radius_->setValue(static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * sliderSteps)));
  surface_->setCurrentIndex(static_cast<int>(options.surface));
  kernel_->setCurrentIndex(static_cast<int>(options.basis.kernel));
  offset_->setValue(options.offset * 100.0);
  exterior_->setValue(options.exteriorShare * 100.0);
  master_->setValue(options.master);
  seed_->setValue(options.seed);
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

void PlacementPanel::load() {
  const bool isOpen = document_.isOpen();
  widget()->setEnabled(isOpen);
  if (isOpen) {
    const Topology& topology = document_.shown().mesh->topology();
    surface_->setItemText(0, topology.isClosed ? tr("Automatic: closed") : tr("Automatic"));
  }
  follow();
}

/// Shows what the project has: after a placement, an undo, another project.
void PlacementPanel::follow() {
  const Project& project = document_.committed();
  if (!document_.isOpen() || document_.isPreviewing()) {
    return;
  }
  // While a slider is held, it leads.
  if (!points_->isSliderDown() && !radius_->isSliderDown() && !document_.jobs().isRunning("place")) {
    PlacementOptions options = project.placement;
    options.basis = project.controls.basis;
    options.master = project.controls.master.value;
    options.masterMode = project.controls.master.mode;
    const bool isUnchanged = options == shownOptions_;
    if (!isUnchanged) {
      shownOptions_ = options;
      show(options);
    }
  }
  showFooter();
}

void PlacementPanel::showFooter() {
  const bool isPristine = document_.isPristine();
  keepEdits_->setVisible(!isPristine);
  if (document_.jobs().isRunning("place")) {
    footer_->setText(tr("placing..."));
    return;
  }
  const Index count = document_.isOpen() ? document_.committed().controls.finest().size() : 0;
  const double seconds = document_.lastPlacementSeconds();
  footer_->setText(
      count == 0 ? QString()
      : seconds > 0.0
          ? tr("%1 in %2 s").arg(counted(count), QString::number(seconds, 'f', seconds < 10 ? 2 : 0))
          : tr("%1 points").arg(counted(count)));
}

void PlacementPanel::change(int mergeKey) {
  if (!isLoading_ && document_.isOpen() && document_.isPristine()) {
    place(options(), false, mergeKey);
  }
}

void PlacementPanel::placeAgain() {
  if (document_.isOpen()) {
    place(options(), keepEdits_->isChecked() && !document_.isPristine(), 0);
  }
}

void PlacementPanel::place(const PlacementOptions& options, bool keepEdits, int mergeKey) {
  document_.performInBackground(Place{options, keepEdits, std::nullopt}, {mergeKey});
}

}  // namespace pbffd::ui
