#include "ui/window/point_page.h"

#include "ui/document/document.h"
#include "ui/models/point_filter.h"
#include "ui/window/influence_section.h"
#include "ui/window/labels.h"
#include "ui/window/page_header.h"
#include "ui/window/point_selection.h"
#include "ui/window/pose_section.h"
#include "ui/window/region_section.h"

#include <QVBoxLayout>

#include <algorithm>

namespace pbffd::ui {
namespace {

/// What there is to say of one point.
QStringList describe(const ControlPoint& point, int level) {
  QStringList words;
  if (!point.name.empty()) {
    words += QObject::tr("number %1").arg(point.id);
  }
  if (point.locked) {
    words += QObject::tr("locked");
  }
  if (!point.mergedFrom.empty()) {
    words += QObject::tr("stands for %1 of level %2").arg(point.mergedFrom.size()).arg(level + 1);
  }
  return words;
}

}  // namespace

PointPage::PointPage(Document& document, const Theme& theme, QWidget* parent)
    : QWidget(parent),
      document_(document),
      header_(new PageHeader(theme)),
      pose_(new PoseSection(document, theme)),
      region_(new RegionSection(document, theme)),
      influence_(new InfluenceSection(document, theme)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  column->addWidget(pose_);
  column->addWidget(region_);
  column->addWidget(influence_);
  column->addStretch();
  connect(pose_, &PoseSection::backToRestAsked, this, &PointPage::backToRestAsked);
  connect(pose_, &PoseSection::settled, this, &PointPage::refresh);
  connect(region_, &RegionSection::settled, this, &PointPage::refresh);
}

void PointPage::refresh() {
  const PointsOfLevel points = shownSelection(document_);
  if (points.points.empty()) {
    return;
  }
  showHeader(points);
  pose_->show(points);
  region_->show(points);
  influence_->refreshLater();
}

void PointPage::showHeader(const PointsOfLevel& points) {
  const ControlPoint& active = *points.points.back();
  const bool sameKind = std::all_of(points.points.begin(), points.points.end(),
                                    [&](const ControlPoint* point) { return point->kind == active.kind; });
  const auto count = static_cast<qint64>(points.points.size());
  const QString title = count == 1 ? pointLabel(active) : tr("%1 control points").arg(counted(count));
  QStringList detail{sameKind ? kindTitle(active.kind) : tr("Several kinds"), tr("level %1").arg(points.level)};
  if (points.isWhole) {
    detail += tr("all of it: the whole shape goes along");
  }
  if (count == 1) {
    detail += describe(active, points.level);
  }
  header_->show(
      {sameKind ? kindIcon(active.kind) : "controls", "select", "select.bg", title, detail.join(", ")});
}

}  // namespace pbffd::ui
