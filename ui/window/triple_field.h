#pragma once

#include "ui/models/pose_edits.h"

#include <QWidget>

#include <array>
#include <functional>

class QLabel;

namespace pbffd::ui {

class Document;
class NumberField;
class Theme;

/// Three number fields in a row, for x, y, z or a, b, c, whose input becomes edits: typed values and steps at
/// once, a scrub as one entry when it ends. What is wrong with a value is said below.
class TripleField : public QWidget {
  Q_OBJECT

 public:
  /// The edit that an input means; none where it means nothing.
  using EditMaker = std::function<std::optional<Edit>(int axis, const NumberInput& input)>;
  struct Look {
    QString label;
    std::array<QString, 3> prefixes;  ///< instead of the colours of the axes
    QString suffix = {};              ///< a quiet unit after each
  };

  TripleField(Document& document, const Theme& theme, const Look& look, QWidget* parent = nullptr);

  void setEditMaker(EditMaker maker) { maker_ = std::move(maker); }
  NumberField& field(int axis) const { return *fields_[static_cast<std::size_t>(axis)]; }
  void setDecimals(int decimals);
  void setStep(double step);
  void setStandsForMany(bool many);
  /// Shows values of which some are shared: `mixedAsMiddle` shows the median where they differ.
  void showValues(const std::array<SharedValue, 3>& values, bool mixedAsMiddle);

 Q_SIGNALS:
  /// The values have to be shown again.
  void settled();

 private:
  void connectField(int axis);
  std::optional<Edit> make(int axis, NumberInput::Kind kind, double value) const;
  void nudge(int axis, double delta);
  void scrub(int axis, double delta);
  void endScrub(bool keep);
  void showReason(const QString& reason);

  Document& document_;
  EditMaker maker_;
  std::array<NumberField*, 3> fields_;
  QLabel* reason_;
  std::optional<Edit> waitingScrub_;  ///< too slow to be shown live
  int nudgeKey_ = 0;
  qint64 lastNudge_ = 0;
};

}  // namespace pbffd::ui
