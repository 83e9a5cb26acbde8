#pragma once

#include "ui/models/pose_edits.h"

#include <QWidget>

namespace pbffd::ui {

class Document;
class InfluenceSection;
class PageHeader;
class PoseSection;
class RegionSection;
class Theme;

/// The inspector's page of the selected control points: pose, region of influence, influence.
class PointPage : public QWidget {
  Q_OBJECT

 public:
  PointPage(Document& document, const Theme& theme, QWidget* parent = nullptr);
  void refresh();

 Q_SIGNALS:
  void backToRestAsked();

 private:
  void showHeader(const PointsOfLevel& points);

  Document& document_;
  PageHeader* header_;
  PoseSection* pose_;
  RegionSection* region_;
  InfluenceSection* influence_;
};

}  // namespace pbffd::ui
