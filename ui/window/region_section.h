#pragma once

#include "ui/models/pose_edits.h"
#include "ui/window/section.h"

class QCheckBox;
class QLabel;
class QToolButton;

namespace pbffd::ui {

class Document;
class TripleField;

/// The inspector's section of the selected points' regions: semi-axes, their range, whether they count.
class RegionSection : public Section {
  Q_OBJECT

 public:
  RegionSection(Document& document, const Theme& theme, QWidget* parent = nullptr);
  void show(const PointsOfLevel& points);

 Q_SIGNALS:
  void settled();

 private:
  void showEnabled(const PointsOfLevel& points);

  Document& document_;
  TripleField* semiAxes_;
  QToolButton* uniform_;
  QLabel* range_;
  QCheckBox* enabled_;
};

}  // namespace pbffd::ui
