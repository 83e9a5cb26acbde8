#include "ui/window/point_page.h"

#include "ui/document/document.h"
#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/models/influence.h"
#include "ui/models/point_filter.h"
#include "ui/window/dock.h"
#include "ui/window/histogram.h"
#include "ui/window/labels.h"
#include "ui/window/number_field.h"
#include "ui/window/page_header.h"
#include "ui/window/section.h"

#include <QCheckBox>
#include <QDateTime>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace pbffd::ui {
namespace {

constexpr qint64 nudgeRunMilliseconds = 1000;
/// A scrub is shown live while an update takes no longer; else its end alone is.
constexpr double liveMilliseconds = 30.0;

/// So many that a thousandth of the mesh can be told apart.
int decimalsFor(double diagonal) {
  const double magnitude = std::floor(std::log10(std::max(diagonal, 1e-300)));
  return std::clamp(static_cast<int>(magnitude >= 0.0 ? std::min(3.0, 4.0 - magnitude) : 3.0 - magnitude), 0,
                    12);
}

/// 1, 2 or 5 times a power of ten, near a thousandth of the mesh.
double stepFor(double diagonal) {
  const double wanted = std::max(diagonal, 1e-300) / 1000.0;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  const double ratio = wanted / power;
  return power * (ratio < 1.5 ? 1.0 : ratio < 3.5 ? 2.0 : 5.0);
}

void showShared(NumberField& field, const SharedValue& value, bool mixedAsMiddle) {
  if (value.isMixed && !mixedAsMiddle) {
    field.setMixed(value.middle);
  } else {
    field.setValue(value.middle);
  }
}

}  // namespace

PointPage::PointPage(Document& document, const Theme& theme, QWidget* parent)
    : QWidget(parent), document_(document), theme_(theme), header_(new PageHeader(theme)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  column->addWidget(makePoseSection());
  column->addWidget(makeRegionSection());
  column->addWidget(makeInfluenceSection());
  column->addStretch();
  influenceTimer_.setSingleShot(true);
  influenceTimer_.setInterval(0);
  connect(&influenceTimer_, &QTimer::timeout, this, &PointPage::showInfluence);
}

PointPage::Fields PointPage::makeFields(Section& section, const QString& label,
                                        const std::array<QString, 3>& prefixes) {
  static const char* const axes[] = {"X", "Y", "Z"};
  static const char* const tokens[] = {"axis.x", "axis.y", "axis.z"};
  Fields fields;
  QList<QWidget*> widgets;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool isAxis = prefixes[axis].isEmpty();
    fields[axis] = new NumberField(theme_, {isAxis ? tokens[axis] : "", prefixes[axis], {}});
    fields[axis]->setAccessibleName(label + " " + (isAxis ? QString(axes[axis]) : prefixes[axis]));
    widgets += fields[axis];
  }
  section.body()->addLayout(labelledRow(label, widgets));
  return fields;
}

void PointPage::connectFields(const Fields& fields, const EditMaker& maker) {
  for (int axis = 0; axis < 3; ++axis) {
    NumberField* field = fields[static_cast<std::size_t>(axis)];
    const auto make = [maker, axis](NumberInput::Kind kind, double value) {
      return maker(axis, {kind, value});
    };
    connect(field, &NumberField::entered, this, [this, maker, axis](const NumberInput& input) {
      if (const auto edit = maker(axis, input)) {
        document_.perform(*edit);
      }
      refresh();
    });
    connect(field, &NumberField::nudged, this, [this, make](double delta) {
      const qint64 now = QDateTime::currentMSecsSinceEpoch();
      if (now - std::exchange(lastNudge_, now) > nudgeRunMilliseconds) {
        nudgeKey_ = document_.newMergeKey();
      }
      if (const auto edit = make(NumberInput::Kind::add, delta)) {
        document_.perform(*edit, {nudgeKey_});
      }
    });
    // The edit is made of the committed points, so that each step of a scrub starts from there.
    connect(field, &NumberField::scrubbed, this, [this, make](double delta) {
      waitingScrub_ = make(NumberInput::Kind::add, delta);
      if (waitingScrub_ && document_.lastMilliseconds() < liveMilliseconds &&
          document_.preview(*waitingScrub_)) {
        waitingScrub_.reset();
      }
    });
    connect(field, &NumberField::scrubEnded, this, &PointPage::endScrub);
  }
}

void PointPage::endScrub(bool keep) {
  const std::optional<Edit> waiting = std::exchange(waitingScrub_, std::nullopt);
  if (!keep) {
    document_.cancelPreview();
  } else if (waiting) {
    document_.perform(*waiting);
  } else {
    document_.commitPreview();
  }
  refresh();
}

Section* PointPage::makePoseSection() {
  auto* section = new Section(theme_, tr("Pose"));
  position_ = makeFields(*section, tr("Position"), {});
  offset_ = makeFields(*section, tr("From rest"), {});
  rotation_ = makeFields(*section, tr("Rotation"), {});
  for (NumberField* field : rotation_) {
    field->setDecimals(1);
    field->setStep(0.5);
    field->setToolTip(tr("Degrees"));
  }
  connectFields(position_,
                [this](int axis, const NumberInput& input) { return positionEdit(selection(), axis, input); });
  connectFields(offset_,
                [this](int axis, const NumberInput& input) { return offsetEdit(selection(), axis, input); });
  connectFields(rotation_,
                [this](int axis, const NumberInput& input) { return rotationEdit(selection(), axis, input); });
  backToRest_ = new QPushButton(tr(" Back to rest"));
  backToRest_->setIcon(makeIcon(theme_, "undo", {"text.2", "text.2"}));
  backToRest_->setIconSize({14, 14});
  connect(backToRest_, &QPushButton::clicked, this, &PointPage::backToRestAsked);
  auto* row = labelledRow({}, {backToRest_});
  row->addStretch();
  section->body()->addLayout(row);
  return section;
}

Section* PointPage::makeRegionSection() {
  auto* section = new Section(theme_, tr("Region of influence"));
  section->setToolTip(tr("ROI: where this point moves the mesh, an ellipsoid"));
  semiAxes_ = makeFields(*section, tr("Semi-axes"), {"a", "b", "c"});
  for (NumberField* field : semiAxes_) {
    field->setRange(1e-12, 1e300);
  }
  connectFields(semiAxes_, [this](int axis, const NumberInput& input) {
    return regionEdit(selection(), axis, input, uniform_->isChecked());
  });
  range_ = makeLabel({}, "label");
  uniform_ = makeIconButton(theme_, "link", tr("Scale all three together"));
  uniform_->setProperty("role", "flat");
  uniform_->setCheckable(true);
  auto* row = labelledRow(tr("Range"), {range_});
  row->addStretch();
  row->addWidget(uniform_);
  section->body()->addLayout(row);
  enabled_ = new QCheckBox;
  enabled_->setAccessibleName(tr("Enabled"));
  connect(enabled_, &QCheckBox::clicked, this,
          [this] { setEnabledState(enabled_->checkState() != Qt::Unchecked); });
  row = labelledRow(tr("Enabled"), {enabled_});
  row->addStretch();
  section->body()->addLayout(row);
  return section;
}

QLabel* PointPage::addValueRow(Section& section, const QString& name) {
  auto* row = new QHBoxLayout;
  QLabel* value = makeLabel({}, "value");
  value->setAccessibleName(name);
  QLabel* label = makeLabel(name, "label");
  label->setObjectName("name");
  row->addWidget(label);
  row->addStretch();
  row->addWidget(value);
  section.body()->addLayout(row);
  value->setBuddy(label);
  return value;
}

Section* PointPage::makeInfluenceSection() {
  auto* section = new Section(theme_, tr("Influence"));
  histogram_ = new Histogram(theme_);
  histogram_->setAccessibleName(tr("Weights of the selection where it reaches"));
  histogram_->setToolTip(tr("How much of what is reached has which weight of the selection"));
  section->body()->addWidget(histogram_);
  auto* scale = new QHBoxLayout;
  scale->addWidget(makeLabel(tr("weight 0"), "caption"));
  scale->addStretch();
  scale->addWidget(makeLabel("1", "caption"));
  section->body()->addLayout(scale);
  reached_ = addValueRow(*section, tr("Vertices reached"));
  reachedName_ = static_cast<QLabel*>(reached_->buddy());
  strongest_ = addValueRow(*section, tr("Strongest weight"));
  return section;
}

/// Of the committed project: what an edit starts from.
PointsOfLevel PointPage::selection() const {
  PointsOfLevel result{document_.selection().level(), {}};
  const auto& levels = document_.committed().controls.levels;
  const auto place = static_cast<std::size_t>(document_.editLevel());
  if (!document_.isOpen() || place >= levels.size()) {
    return result;
  }
  for (const PointId id : document_.selection().points()) {
    if (const auto at = levels[place].find(id)) {
      result.points.push_back(&levels[place][*at]);
    }
  }
  return result;
}

void PointPage::refresh() {
  PointsOfLevel points{document_.selection().level(), {}};
  const auto& levels = document_.shown().controls.levels;
  const auto place = static_cast<std::size_t>(document_.editLevel());
  if (place >= levels.size()) {
    return;
  }
  for (const PointId id : document_.selection().points()) {
    if (const auto at = levels[place].find(id)) {
      points.points.push_back(&levels[place][*at]);
    }
  }
  if (points.points.empty()) {
    return;
  }
  showHeader(points);
  showPose(points);
  showRegion(points);
  if (!document_.isPreviewing()) {
    influenceTimer_.start();
  }
}

void PointPage::showHeader(const PointsOfLevel& points) {
  const ControlPoint& active = *points.points.back();
  const bool sameKind = std::all_of(points.points.begin(), points.points.end(),
                                    [&](const ControlPoint* point) { return point->kind == active.kind; });
  const std::size_t count = points.points.size();
  const QString title =
      count == 1 ? pointLabel(active) : tr("%1 control points").arg(counted(static_cast<qint64>(count)));
  QString detail =
      (sameKind ? kindTitle(active.kind) : tr("Several kinds")) + tr(", level %1").arg(points.level);
  if (count == 1 && !active.name.empty()) {
    detail += tr(", number %1").arg(active.id);
  }
  if (count == 1 && active.locked) {
    detail += tr(", locked");
  }
  header_->show({sameKind ? kindIcon(active.kind) : "controls", "select", "select.bg", title, detail});
}

void PointPage::showPose(const PointsOfLevel& points) {
  const double diagonal = document_.shown().mesh->diagonal();
  const bool isAtRest = std::all_of(points.points.begin(), points.points.end(),
                                    [](const ControlPoint* point) { return point->pose == point->rest; });
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<std::size_t>(axis);
    std::vector<double> positions;
    std::vector<double> offsets;
    std::vector<double> angles;
    for (const ControlPoint* point : points.points) {
      positions.push_back(point->pose.center[axis]);
      offsets.push_back(point->pose.center[axis] - point->rest.center[axis]);
      angles.push_back(rotationAngles(*point)[axis]);
    }
    for (NumberField* field : {position_[at], offset_[at], semiAxes_[at]}) {
      field->setDecimals(decimalsFor(diagonal));
      field->setStep(stepFor(diagonal));
    }
    for (NumberField* field : {position_[at], offset_[at], rotation_[at], semiAxes_[at]}) {
      field->setStandsForMany(points.points.size() > 1);
    }
    showShared(*position_[at], shared(positions), true);
    showShared(*offset_[at], shared(offsets), true);
    showShared(*rotation_[at], shared(angles), false);
  }
  backToRest_->setEnabled(!isAtRest);
}

void PointPage::showRegion(const PointsOfLevel& points) {
  double smallest = 1e300;
  double largest = 0.0;
  std::size_t enabled = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> lengths;
    for (const ControlPoint* point : points.points) {
      lengths.push_back(point->rest.axes.col(axis).norm());
    }
    const auto [low, high] = std::minmax_element(lengths.begin(), lengths.end());
    smallest = std::min(smallest, *low);
    largest = std::max(largest, *high);
    showShared(*semiAxes_[static_cast<std::size_t>(axis)], shared(lengths), false);
  }
  for (const ControlPoint* point : points.points) {
    enabled += point->enabled ? 1 : 0;
  }
  const int decimals = decimalsFor(document_.shown().mesh->diagonal());
  const QString low = NumberField::formatted(smallest, decimals);
  const QString high = NumberField::formatted(largest, decimals);
  range_->setText(low == high ? tr("%1 units").arg(low) : tr("%1 to %2 units").arg(low, high));
  const QSignalBlocker quiet(enabled_);
  const std::size_t count = points.points.size();
  enabled_->setTristate(enabled != 0 && enabled != count);
  enabled_->setCheckState(enabled == 0 ? Qt::Unchecked : enabled == count ? Qt::Checked : Qt::PartiallyChecked);
  enabled_->setText(count == 1         ? QString()
                    : enabled == count ? tr("all %1").arg(counted(static_cast<qint64>(count)))
                                       : tr("%1 of %2").arg(enabled).arg(counted(static_cast<qint64>(count))));
}

void PointPage::showInfluence() {
  if (!document_.isOpen() || document_.selection().isEmpty() || document_.parameterization() == nullptr) {
    return;
  }
  const auto& levels = document_.shown().controls.levels;
  const auto place = static_cast<std::size_t>(document_.editLevel());
  if (place >= levels.size()) {
    return;
  }
  const bool isFinest = place + 1 == levels.size();
  const auto& points = document_.selection().points();
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

void PointPage::setEnabledState(bool enabled) {
  document_.perform(Enable{{document_.selection().level(), document_.selection().points()}, enabled});
  refresh();
}

}  // namespace pbffd::ui
