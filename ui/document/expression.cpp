#include "ui/document/expression.h"

#include <QString>

#include <cmath>

namespace pbffd::ui {
namespace {

/// A descent over sum := product {+|- product}, product := factor {*|/ factor},
/// factor := {-|+} (number | '(' sum ')').
class Parser {
 public:
  explicit Parser(QString text) : text_(std::move(text)) {}

  std::optional<double> parse() {
    const double value = sum();
    if (failed_ || at_ != text_.size() || !std::isfinite(value)) {
      return std::nullopt;
    }
    return value;
  }

 private:
  QChar next() const { return at_ < text_.size() ? text_[at_] : QChar(); }

  bool take(char wanted) {
    if (next() != QLatin1Char(wanted)) {
      return false;
    }
    ++at_;
    return true;
  }

  double sum() {
    double value = product();
    while (!failed_) {
      if (take('+')) {
        value += product();
      } else if (take('-')) {
        value -= product();
      } else {
        break;
      }
    }
    return value;
  }

  double product() {
    double value = factor();
    while (!failed_) {
      if (take('*')) {
        value *= factor();
      } else if (take('/')) {
        value /= factor();
      } else {
        break;
      }
    }
    return value;
  }

  double factor() {
    if (++depth_ > maximumDepth) {
      failed_ = true;
      return 0.0;
    }
    double value = 0.0;
    if (take('-')) {
      value = -factor();
    } else if (take('+')) {
      value = factor();
    } else if (take('(')) {
      value = sum();
      failed_ |= !take(')');
    } else {
      value = number();
    }
    --depth_;
    return value;
  }

  double number() {
    const qsizetype start = at_;
    const auto digits = [&] {
      while (next().isDigit()) {
        ++at_;
      }
    };
    digits();
    if (take('.')) {
      digits();
    }
    if (at_ > start && (next() == u'e' || next() == u'E')) {
      ++at_;
      if (!take('-')) {
        take('+');
      }
      digits();
    }
    bool ok = false;
    const double value = QStringView(text_).mid(start, at_ - start).toDouble(&ok);
    failed_ |= !ok;
    return value;
  }

  static constexpr int maximumDepth = 100;
  QString text_;
  qsizetype at_ = 0;
  int depth_ = 0;
  bool failed_ = false;
};

QString withoutDecoration(QStringView text) {
  QString plain;
  for (const QChar character : text) {
    if (character == QChar(0x2212)) {
      plain += u'-';
    } else if (character == QChar(0x00d7)) {
      plain += u'*';
    } else if (character == u',') {
      plain += u'.';
    } else if (!character.isSpace()) {
      plain += character;
    }
  }
  return plain;
}

}  // namespace

std::optional<double> evaluateExpression(QStringView text) {
  return Parser(withoutDecoration(text)).parse();
}

double NumberInput::appliedTo(double present) const {
  switch (kind) {
    case Kind::add:
      return present + value;
    case Kind::multiply:
      return present * value;
    case Kind::set:
      break;
  }
  return value;
}

std::optional<NumberInput> parseNumberInput(QStringView text, bool relativeSums) {
  const QString plain = withoutDecoration(text);
  const auto rest = [&] { return evaluateExpression(QStringView(plain).mid(1)); };
  if (plain.startsWith(u'*')) {
    const auto factor = rest();
    return factor ? std::optional(NumberInput{NumberInput::Kind::multiply, *factor}) : std::nullopt;
  }
  if (plain.startsWith(u'/')) {
    const auto divisor = rest();
    const bool usable = divisor && *divisor != 0.0;
    return usable ? std::optional(NumberInput{NumberInput::Kind::multiply, 1.0 / *divisor}) : std::nullopt;
  }
  if (relativeSums && plain.startsWith(u'+')) {
    const auto term = rest();
    return term ? std::optional(NumberInput{NumberInput::Kind::add, *term}) : std::nullopt;
  }
  const auto value = evaluateExpression(plain);
  return value ? std::optional(NumberInput{NumberInput::Kind::set, *value}) : std::nullopt;
}

}  // namespace pbffd::ui
