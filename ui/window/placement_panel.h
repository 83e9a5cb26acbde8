#pragma once

#include "core/ffd/placement.h"

#include <QScrollArea>
#include <QTimer>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace pbffd::ui {

class Document;
class NumberField;
class Segments;
class Theme;

/// The placement dock's content. While nothing is edited every change places anew at once; afterwards the
/// numbers wait for `Place again`.
class PlacementPanel : public QScrollArea {
  Q_OBJECT

 public:
  PlacementPanel(Document& document, const Theme& theme, QWidget* parent = nullptr);

  /// What the panel asks for now.
  PlacementOptions options() const;
  void placeAgain();
  QSlider* pointsSlider() const { return points_; }

 private:
  QLayout* makePointsRow();
  QLayout* makeRadiusRow();
  QWidget* makeMore();
  QLayout* makeFooter();
  void connectMore();

  void load();
  void show(const PlacementOptions& options);
  void follow();
  void showFooter();
  void change(int mergeKey);
  int scrubKey(const QSlider& slider);
  void place(const PlacementOptions& options, bool keepEdits, int mergeKey);

  Document& document_;
  const Theme& theme_;
  PlacementOptions base_;                         ///< those that the panel has no field for
  std::optional<PlacementOptions> shownOptions_;  ///< the project's, when they were shown last
  QSlider* points_;
  NumberField* pointsField_;
  Segments* levels_;
  QSlider* radius_;
  NumberField* radiusField_;
  QComboBox* surface_;
  QComboBox* kernel_;
  NumberField* offset_;
  NumberField* exterior_;
  QComboBox* sites_;
  NumberField* master_;
  NumberField* seed_;
  QPushButton* paper_;
  QPushButton* again_;
  QCheckBox* keepEdits_;
  QLabel* footer_;
  QTimer keyTimer_;
  int scrubKey_ = 0;
  bool isLoading_ = false;
};

}  // namespace pbffd::ui
