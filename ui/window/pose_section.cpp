#include "ui/window/pose_section.h"

#include "ui/document/document.h"
#include "ui/document/icons.h"
#include "ui/window/number_field.h"
#include "ui/window/point_selection.h"
#include "ui/window/triple_field.h"

#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace pbffd::ui {
namespace {

/// What `valueOf(point)` gives for all points, axis by axis.
template <class ValueOf>
std::array<SharedValue, 3> sharedBy(const PointsOfLevel& points, const ValueOf& valueOf) {
  std::array<std::vector<double>, 3> values;
  for (const ControlPoint* point : points.points) {
    const Vec3 value = valueOf(*point);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      values[axis].push_back(value[static_cast<Eigen::Index>(axis)]);
    }
  }
  return {shared(values[0]), shared(values[1]), shared(values[2])};
}

}  // namespace

PoseSection::PoseSection(Document& document, const Theme& theme, QWidget* parent)
    : Section(theme, tr("Pose"), parent),
      document_(document),
      position_(new TripleField(document, theme, {tr("Position"), {}})),
      offset_(new TripleField(document, theme, {tr("From rest"), {}})),
      rotation_(new TripleField(document, theme, {tr("Rotation"), {}, tr("°")})),
      backToRest_(new QPushButton(tr(" Back to rest"))) {
  position_->setEditMaker([this](int axis, const NumberInput& input) {
    return positionEdit(committedSelection(document_), axis, input);
  });
  offset_->setEditMaker([this](int axis, const NumberInput& input) {
    return offsetEdit(committedSelection(document_), axis, input);
  });
  rotation_->setEditMaker([this](int axis, const NumberInput& input) {
    return rotationEdit(committedSelection(document_), axis, input);
  });
  rotation_->setDecimals(1);
  rotation_->setStep(0.5);
  rotation_->setToolTip(tr("Degrees about the global axes"));
  backToRest_->setIcon(makeIcon(theme, "undo", {"text.2", "text.2"}));
  backToRest_->setIconSize({14, 14});
  connect(backToRest_, &QPushButton::clicked, this, &PoseSection::backToRestAsked);
  for (TripleField* field : {position_, offset_, rotation_}) {
    connect(field, &TripleField::settled, this, &PoseSection::settled);
    body()->addWidget(field);
  }
  auto* row = labelledRow({}, {backToRest_});
  row->addStretch();
  body()->addLayout(row);
}

void PoseSection::show(const PointsOfLevel& points) {
  const double diagonal = document_.shown().mesh->diagonal();
  for (TripleField* field : {position_, offset_}) {
    field->setDecimals(decimalsFor(diagonal));
    field->setStep(stepFor(diagonal));
  }
  for (TripleField* field : {position_, offset_, rotation_}) {
    field->setStandsForMany(points.points.size() > 1);
  }
  position_->showValues(sharedBy(points, [](const ControlPoint& point) { return point.pose.center; }), true);
  offset_->showValues(
      sharedBy(points, [](const ControlPoint& point) { return Vec3(point.pose.center - point.rest.center); }),
      true);
  rotation_->showValues(sharedBy(points, rotationAngles), false);
  backToRest_->setEnabled(std::any_of(points.points.begin(), points.points.end(),
                                      [](const ControlPoint* point) { return !(point->pose == point->rest); }));
}

}  // namespace pbffd::ui
