#pragma once

#include <QTimer>
#include <QWidget>

#include <functional>

class QSlider;

namespace pbffd::ui {

class NumberField;
class Theme;

/// A number as a slider for its usual range with a field for all of it.
class SliderRow : public QWidget {
  Q_OBJECT

 public:
  struct Look {
    QString label;
    QString accessibleName;
    QString suffix;
    int decimals = 0;
    double low = 0.0;  ///< of the field
    double high = 1.0;
    double step = 1.0;
  };
  /// Where a value lies on the slider, whose ends are 0 and 1, and the value that is meant there.
  struct Scale {
    std::function<double(double share)> valueAt;
    std::function<double(double value)> shareOf;
  };

  SliderRow(const Theme& theme, const Look& look, Scale scale, QWidget* parent = nullptr);

  double value() const;
  /// Without `changed`.
  void setValue(double value);
  bool isHeld() const;
  QSlider* slider() const { return slider_; }

 Q_SIGNALS:
  /// By the user. `startsRun`: the first step of a drag of the slider, of keys or wheel turns one right after
  /// the other, or a typed number; the steps that follow belong to the same run.
  void changed(bool startsRun);

 private:
  void slide(int position);
  void enter(double value, bool isTyped);
  void announce(bool startsRun);

  Scale scale_;
  QSlider* slider_;
  NumberField* field_;
  QTimer run_;  ///< active while another step belongs to the same run
  bool isNewDrag_ = false;
  bool isSetting_ = false;
};

}  // namespace pbffd::ui
