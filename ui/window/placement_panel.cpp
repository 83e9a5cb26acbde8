#include "ui/window/placement_panel.h"

#include "ui/document/document.h"
#include "ui/document/job_runner.h"
#include "ui/document/theme.h"
#include "ui/window/labels.h"
#include "ui/window/placement_more.h"
#include "ui/window/section.h"
#include "ui/window/segments.h"
#include "ui/window/slider_row.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr double fewestPoints = 20.0;
constexpr double mostSliderPoints = 2000.0;
constexpr double mostPoints = 20000.0;
constexpr double leastRadius = 1.0;
constexpr double mostRadius = 3.0;
constexpr double radiusStep = 0.05;
constexpr int highestLevelCount = 5;

SliderRow::Scale pointsScale() {
  const auto valueAt = [](double share) {
    const double points = fewestPoints * std::pow(mostSliderPoints / fewestPoints, share);
    // Round figures where one point more or less cannot be aimed at.
    const double grain = points < 200 ? 1.0 : points < 500 ? 5.0 : 10.0;
    return std::round(points / grain) * grain;
  };
  const auto shareOf = [](double points) {
    return std::log(std::max(points, 1.0) / fewestPoints) / std::log(mostSliderPoints / fewestPoints);
  };
  return {valueAt, shareOf};
}

SliderRow::Scale radiusScale() {
  const auto valueAt = [](double share) {
    return std::round((leastRadius + (mostRadius - leastRadius) * share) / radiusStep) * radiusStep;
  };
  const auto shareOf = [](double factor) { return (factor - leastRadius) / (mostRadius - leastRadius); };
  return {valueAt, shareOf};
}

}  // namespace

PlacementPanel::PlacementPanel(Document& document, const Theme& theme, QWidget* parent)
    : QScrollArea(parent), document_(document) {
  setAccessibleName(tr("Placement"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::NoFocus);
  makeRows(theme);
  auto* content = new QWidget;
  content->setProperty("role", "dock");
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(12, 10, 12, 10);
  column->setSpacing(7);
  column->addWidget(points_);
  auto* levelRow = labelledRow(tr("Levels"), {levels_});
  levelRow->addStretch();
  column->addLayout(levelRow);
  column->addWidget(radius_);
  column->addLayout(labelledRow(tr("Surface"), {surface_}));
  column->addWidget(more_);
  column->addLayout(makeFooter());
  column->addStretch();
  setWidget(content);
  connectRows();
  load();
}

void PlacementPanel::makeRows(const Theme& theme) {
  points_ = new SliderRow(theme, {tr("Points"), tr("Number of control points"), {}, 0, 1.0, mostPoints, 1.0},
                          pointsScale());
  levels_ = new Segments(theme);
  std::vector<Segments::Segment> counts;
  for (int level = 1; level <= highestLevelCount; ++level) {
    counts.push_back({QString::number(level), {}, level == 1 ? tr("1 level") : tr("%1 levels").arg(level)});
  }
  levels_->setSegments(counts);
  levels_->setAccessibleName(tr("Levels"));
  radius_ = new SliderRow(theme,
                          {tr("Radius"), tr("Radius of the regions, times the distance to the nearest point"),
                           QString(QChar(0x00d7)), 2, 0.1, 20.0, radiusStep},
                          radiusScale());
  radius_->setToolTip(tr("Radius of each region, in distances to the nearest control point"));
  surface_ = new QComboBox;
  surface_->addItems({tr("Automatic"), tr("Closed"), tr("Open")});
  surface_->setAccessibleName(tr("Surface"));
  surface_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  more_ = new PlacementMore(theme);
}

QLayout* PlacementPanel::makeFooter() {
  auto* again = new QPushButton(tr("Place again"));
  connect(again, &QPushButton::clicked, this, &PlacementPanel::placeAgain);
  keepEdits_ = new QCheckBox(tr("Keep edits"));
  keepEdits_->setToolTip(tr("New points take over the deformation of their places"));
  keepEdits_->setChecked(true);
  footer_ = makeLabel({}, "quiet");
  footer_->setObjectName("placementFigures");
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(again);
  row->addWidget(keepEdits_);
  row->addStretch();
  // A row of its own: beside both there is no room for it.
  auto* rows = new QVBoxLayout;
  rows->setContentsMargins(0, 6, 0, 0);
  rows->addLayout(row);
  rows->addWidget(footer_);
  return rows;
}

void PlacementPanel::connectRows() {
  connect(points_, &SliderRow::changed, this, &PlacementPanel::change);
  connect(radius_, &SliderRow::changed, this, &PlacementPanel::change);
  connect(more_, &PlacementMore::changed, this, &PlacementPanel::change);
  connect(levels_, &Segments::chosen, this, [this] { change(true); });
  connect(surface_, &QComboBox::activated, this, [this] { change(true); });
  // Kernel and master need no other points: they are edits of their own.
  connect(more_, &PlacementMore::kernelChosen, this, [this](Kernel kernel) {
    document_.perform(SetKernel{{kernel, base_.basis.sigma}});
  });
  connect(more_, &PlacementMore::masterEntered, this, [this](double value) {
    document_.perform(SetMaster{value, MasterMode::constant});
  });
  connect(more_, &PlacementMore::paperAsked, this, [this] {
    PlacementOptions paper = paperOptions();
    paper.points = options().points;
    paper.levels = options().levels;
    showOptions(paper);
    change(true);
  });
  connect(&document_, &Document::opened, this, &PlacementPanel::load);
  connect(&document_, &Document::changed, this, &PlacementPanel::follow);
  connect(&document_, &Document::placed, this, &PlacementPanel::showFooter);
  connect(&document_, &Document::placed, this, [this] { isPlacing_ = false; });
  connect(&document_.jobs(), &JobRunner::started, this, [this] {
    isPlacing_ = document_.jobs().isRunning("place");
    showFooter();
  });
  // Who cancels a placement does not want the one that would follow it.
  connect(&document_.jobs(), &JobRunner::cancelled, this, [this] {
    if (isPlacing_) {
      waiting_.reset();
    }
  });
  connect(&document_.jobs(), &JobRunner::finished, this, &PlacementPanel::placeWaiting);
}

QSlider* PlacementPanel::pointsSlider() const {
  return points_->slider();
}

PlacementOptions PlacementPanel::options() const {
  PlacementOptions options = more_->over(base_);
  options.points = static_cast<int>(std::lround(points_->value()));
  options.levels = std::max(levels_->current(), 0) + 1;
  options.radiusFactor = radius_->value();
  options.surface = static_cast<Surface>(surface_->currentIndex());
  return options;
}

void PlacementPanel::showOptions(const PlacementOptions& options) {
  base_ = options;
  points_->setValue(options.points);
  levels_->setCurrent(std::clamp(options.levels, 1, highestLevelCount) - 1);
  radius_->setValue(options.radiusFactor);
  surface_->setCurrentIndex(static_cast<int>(options.surface));
  more_->show(options);
}

void PlacementPanel::load() {
  waiting_.reset();
  shownOptions_.reset();
  widget()->setEnabled(document_.isOpen());
  if (document_.isOpen()) {
    const bool isClosed = document_.shown().mesh->topology().isClosed;
    surface_->setItemText(0, isClosed ? tr("Automatic: closed") : tr("Automatic: open"));
  }
  follow();
}

/// Shows what the project has: after a placement, an undo, another project.
void PlacementPanel::follow() {
  if (!document_.isOpen() || document_.isPreviewing()) {
    return;
  }
  // Who is still changing the numbers leads.
  if (!points_->isHeld() && !radius_->isHeld() && !waiting_) {
    PlacementOptions options = document_.committed().placement;
    // Levels that came or went since then are what the next placement is to have; before the first placement
    // there is an empty one, which tells nothing.
    if (!document_.committed().controls.finest().empty()) {
      options.levels = static_cast<int>(document_.committed().controls.levels.size());
    }
    options.basis = document_.committed().controls.basis;
    options.master = document_.committed().controls.master.value;
    options.masterMode = document_.committed().controls.master.mode;
    if (options != shownOptions_) {
      shownOptions_ = options;
      showOptions(options);
    }
  }
  showFooter();
}

void PlacementPanel::showFooter() {
  keepEdits_->setVisible(!document_.isPristine());
  if (document_.jobs().isRunning("place")) {
    return footer_->setText(tr("placing..."));
  }
  const Index count = document_.isOpen() ? document_.committed().controls.finest().size() : 0;
  const double seconds = document_.lastPlacementSeconds();
  footer_->setText(
      count == 0 ? QString()
      : seconds > 0.0
          ? tr("%1 in %2 s").arg(counted(count), QString::number(seconds, 'f', seconds < 10 ? 2 : 0))
          : tr("%1 points").arg(counted(count)));
}

/// A newer change does not stop a placement that runs: it would never come to an end while a slider moves,
/// and what it finds out about the mesh makes the next one quick.
void PlacementPanel::change(bool startsRun) {
  if (startsRun || mergeKey_ == 0) {
    mergeKey_ = document_.newMergeKey();
  }
  if (!document_.isOpen() || !document_.isPristine()) {
    return;
  }
  if (document_.jobs().isRunning()) {
    waiting_ = mergeKey_;
  } else {
    place(false, mergeKey_);
  }
}

void PlacementPanel::placeWaiting() {
  if (const auto key = std::exchange(waiting_, std::nullopt); key && document_.isPristine()) {
    place(false, *key);
  } else {
    if (std::exchange(isPlacing_, false)) {
      shownOptions_.reset();  // it came to nothing: not what was asked for, but what there is
    }
    follow();
  }
  showFooter();
}

void PlacementPanel::placeAgain() {
  if (document_.isOpen()) {
    place(keepEdits_->isChecked() && !document_.isPristine(), 0);
  }
}

void PlacementPanel::place(bool keepEdits, int mergeKey) {
  document_.performInBackground(Place{options(), keepEdits, std::nullopt}, {mergeKey});
}

}  // namespace pbffd::ui
