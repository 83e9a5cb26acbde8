#pragma once

#include <QStringView>

#include <optional>

namespace pbffd::ui {

/// The value of a sum as one types it: numbers with point or comma, + - * / and brackets, a minus sign of
/// either kind; spaces do not matter. None when it is no such sum, or its value is not finite.
std::optional<double> evaluateExpression(QStringView text);

/// What a number field was told.
struct NumberInput {
  enum class Kind {
    set,       ///< the value is this
    add,       ///< "+0.2" on several values: each grows by this
    multiply,  ///< "*1.1", "/2": each is multiplied by this
  };
  Kind kind = Kind::set;
  double value = 0.0;

  /// What it makes of a present value.
  double appliedTo(double present) const;
};

/// `relativeSums`: a leading + is an addition (for fields that stand for several values), else a sign.
std::optional<NumberInput> parseNumberInput(QStringView text, bool relativeSums);

}  // namespace pbffd::ui
