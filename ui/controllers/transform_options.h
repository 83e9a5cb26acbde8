#pragma once

#include <QObject>

namespace pbffd::ui {

enum class AxesChoice { global, local, view };
enum class PivotChoice { median, active, each };

/// How the tools move, rotate and scale: what the options bar sets.
class TransformOptions : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  AxesChoice axes() const { return axes_; }
  void setAxes(AxesChoice axes);
  PivotChoice pivot() const { return pivot_; }
  void setPivot(PivotChoice pivot);
  /// Whether drags go in steps without Ctrl held (Ctrl then turns it off).
  bool snaps() const { return snaps_; }
  void setSnaps(bool snaps);

 Q_SIGNALS:
  void changed();

 private:
  AxesChoice axes_ = AxesChoice::global;
  PivotChoice pivot_ = PivotChoice::median;
  bool snaps_ = false;
};

}  // namespace pbffd::ui
