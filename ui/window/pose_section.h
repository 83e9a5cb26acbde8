#pragma once

#include "ui/models/pose_edits.h"
#include "ui/window/section.h"

class QPushButton;

namespace pbffd::ui {

class Document;
class TripleField;

/// The inspector's section of the selected points' poses: position, offset from rest, rotation.
class PoseSection : public Section {
  Q_OBJECT

 public:
  PoseSection(Document& document, const Theme& theme, QWidget* parent = nullptr);
  void show(const PointsOfLevel& points);

 Q_SIGNALS:
  void backToRestAsked();
  void settled();

 private:
  Document& document_;
  TripleField* position_;
  TripleField* offset_;
  TripleField* rotation_;
  QPushButton* backToRest_;
};

}  // namespace pbffd::ui
