#pragma once

#include "core/ffd/placement/placement.h"

#include <QScrollArea>

#include <optional>

class QCheckBox;
class QComboBox;
class QLabel;
class QSlider;

namespace pbffd::ui {

class Document;
class PlacementMore;
class Segments;
class SliderRow;
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
  QSlider* pointsSlider() const;

 private:
  void makeRows(const Theme& theme);
  QLayout* makeFooter();
  void connectRows();

  void load();
  void showOptions(const PlacementOptions& options);
  void follow();
  void showFooter();
  void change(bool startsRun);
  void place(bool keepEdits, int mergeKey);
  void placeWaiting();

  Document& document_;
  PlacementOptions base_;                         ///< those that the panel has no field for
  std::optional<PlacementOptions> shownOptions_;  ///< the project's, when they were shown last
  std::optional<int> waiting_;                    ///< the merge key of a change that came while one was placed
  int mergeKey_ = 0;
  bool isPlacing_ = false;  ///< until it came to an end, good or bad
  SliderRow* points_;
  Segments* levels_;
  SliderRow* radius_;
  QComboBox* surface_;
  PlacementMore* more_;
  QCheckBox* keepEdits_;
  QLabel* footer_;
};

}  // namespace pbffd::ui
