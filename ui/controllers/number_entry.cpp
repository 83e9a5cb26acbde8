#include "ui/controllers/number_entry.h"

#include "ui/document/expression.h"

#include <algorithm>

namespace pbffd::ui {

void NumberEntry::setCount(int count) {
  count_ = std::clamp(count, 1, 3);
  for (int i = count_; i < 3; ++i) {
    texts_[i].clear();
  }
  field_ = std::min(field_, count_ - 1);
}

bool NumberEntry::accepts(QChar character) {
  return (character >= QLatin1Char('0') && character <= QLatin1Char('9')) ||
         QStringLiteral(".,+-*/()").contains(character);
}

void NumberEntry::type(QChar character) {
  if (accepts(character)) {
    texts_[field_].append(character);
  }
}

void NumberEntry::erase() {
  if (texts_[field_].isEmpty() && field_ > 0) {
    --field_;
  } else {
    texts_[field_].chop(1);
  }
}

void NumberEntry::next() {
  field_ = (field_ + 1) % count_;
}

void NumberEntry::clear() {
  texts_ = {};
  field_ = 0;
}

bool NumberEntry::isEmpty() const {
  return std::all_of(texts_.begin(), texts_.end(), [](const QString& text) { return text.isEmpty(); });
}

std::optional<double> NumberEntry::value(int field) const {
  const QString& text = texts_[field];
  return text.isEmpty() ? 0.0 : evaluateExpression(text);
}

}  // namespace pbffd::ui
