#pragma once

#include <QString>

#include <array>
#include <optional>

namespace pbffd::ui {

/// The numbers that are typed during a gesture: up to three, with Tab from one to the next. A value.
class NumberEntry {
 public:
  /// How many numbers the gesture takes now: 1 along an axis, 2 in a plane, 3 freely. What was typed beyond
  /// them is dropped.
  void setCount(int count);
  int count() const { return count_; }

  /// Whether the character can be part of a number or a sum of numbers.
  static bool accepts(QChar character);
  void type(QChar character);
  void erase();
  void next();
  void clear();

  /// Nothing typed: the mouse rules.
  bool isEmpty() const;
  int field() const { return field_; }
  const QString& text(int field) const { return texts_[field]; }
  /// The typed number; 0 for an empty field beside typed ones; none when it is not a number (yet).
  std::optional<double> value(int field) const;

 private:
  std::array<QString, 3> texts_;
  int count_ = 3;
  int field_ = 0;
};

}  // namespace pbffd::ui
