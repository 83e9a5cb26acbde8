#pragma once

#include "core/ffd/placement/placement.h"

#include <QWidget>

class QComboBox;

namespace pbffd::ui {

class NumberField;
class Theme;

/// The placement options that are seldom changed, folded away under "More".
class PlacementMore : public QWidget {
  Q_OBJECT

 public:
  explicit PlacementMore(const Theme& theme, QWidget* parent = nullptr);

  void show(const PlacementOptions& options);
  /// Puts what the fields say into `options`.
  PlacementOptions over(PlacementOptions options) const;
  void setOpen(bool open);

 Q_SIGNALS:
  /// An option that another placement has to follow.
  void changed(bool startsRun);
  void kernelChosen(Kernel kernel);
  void masterEntered(double value);
  void paperAsked();

 private:
  NumberField* makeField(const QString& name, const QString& suffix, int decimals);
  void makeFields();
  void connectField(NumberField* field);

  const Theme& theme_;
  QComboBox* kernel_;
  QComboBox* regions_;
  NumberField* offset_;
  NumberField* exterior_;
  QComboBox* sites_;
  NumberField* master_;
  NumberField* seed_;
  class QPushButton* fold_;
  QWidget* rows_;
};

}  // namespace pbffd::ui
