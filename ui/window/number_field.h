#pragma once

#include "ui/document/expression.h"

#include <QLineEdit>

#include <optional>

namespace pbffd::ui {

class Theme;

/// A field for one number, or for the same number of several things: drag sideways to scrub, arrow keys to
/// step, arithmetic to type. It shows and tells; the owner decides what the input means and sets the value.
class NumberField : public QLineEdit {
  Q_OBJECT

 public:
  struct Look {
    QString barToken;  ///< colour of the bar at the left: an axis; empty: none
    QString prefix;    ///< a quiet letter before the number
    QString suffix;    ///< a quiet unit after it
  };

  NumberField(const Theme& theme, const Look& look, QWidget* parent = nullptr);

  void setValue(double value);
  /// Several things whose values differ: shows "mixed".
  void setMixed(double middle);
  void setBlank();
  double value() const { return value_; }
  bool isMixed() const { return state_ == State::mixed; }

  void setDecimals(int decimals) { decimals_ = decimals; }
  /// What is typed outside is refused with a reason; scrubbing and steps stop at the ends.
  void setRange(double low, double high);
  /// One arrow key, or one pixel of a scrub.
  void setStep(double step) { step_ = step; }
  /// Stands for several values: a leading + adds to each.
  void setStandsForMany(bool many) { isForMany_ = many; }
  void setScrubbable(bool scrubbable) { isScrubbable_ = scrubbable; }

  /// As the field writes it: rounded, with a real minus sign.
  static QString formatted(double value, int decimals);

 Q_SIGNALS:
  void entered(const pbffd::ui::NumberInput& input);
  void nudged(double delta);
  /// delta: since the scrub began.
  void scrubbed(double delta);
  void scrubEnded(bool keep);
  /// Empty: what was wrong is mended.
  void rejected(const QString& reason);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  enum class State { blank, single, mixed };
  struct Scrub {
    double pressedAt = 0.0;
    double startValue = 0.0;
    bool isMoving = false;
  };

  QString fitting() const;
  void showValue();
  void accept();
  void setBad(const QString& reason);
  void endScrub(bool keep);
  bool isInRange(const NumberInput& input) const;

  const Theme& theme_;
  Look look_;
  State state_ = State::blank;
  double value_ = 0.0;
  int decimals_ = 3;
  double low_ = -1e300;
  double high_ = 1e300;
  double step_ = 0.01;
  bool isForMany_ = false;
  bool isScrubbable_ = true;
  bool isBad_ = false;
  std::optional<Scrub> scrub_;
};

}  // namespace pbffd::ui
