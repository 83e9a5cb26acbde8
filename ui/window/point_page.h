#pragma once

#include "ui/models/pose_edits.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <functional>

class QCheckBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace pbffd::ui {

class Document;
class Histogram;
class NumberField;
class PageHeader;
class Section;
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
  using EditMaker = std::function<std::optional<Edit>(int axis, const NumberInput& input)>;
  using Fields = std::array<NumberField*, 3>;

  Section* makePoseSection();
  Section* makeRegionSection();
  Section* makeInfluenceSection();
  Fields makeFields(Section& section, const QString& label, const std::array<QString, 3>& prefixes);
  void connectFields(const Fields& fields, const EditMaker& maker);
  QLabel* addValueRow(Section& section, const QString& name);

  PointsOfLevel selection() const;
  void showHeader(const PointsOfLevel& points);
  void showPose(const PointsOfLevel& points);
  void showRegion(const PointsOfLevel& points);
  void showInfluence();
  void endScrub(bool keep);
  void setEnabledState(bool enabled);

  Document& document_;
  const Theme& theme_;
  PageHeader* header_;
  Fields position_;
  Fields offset_;
  Fields rotation_;
  Fields semiAxes_;
  QPushButton* backToRest_ = nullptr;
  QToolButton* uniform_ = nullptr;
  QLabel* range_ = nullptr;
  QCheckBox* enabled_ = nullptr;
  Histogram* histogram_ = nullptr;
  QLabel* reachedName_ = nullptr;
  QLabel* reached_ = nullptr;
  QLabel* strongest_ = nullptr;
  QTimer influenceTimer_;
  std::optional<Edit> waitingScrub_;  ///< too slow to be shown live
  int nudgeKey_ = 0;
  qint64 lastNudge_ = 0;
};

}  // namespace pbffd::ui
