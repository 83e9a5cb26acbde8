#include "core/mesh/io/numbers.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>
#include <limits>

namespace pbffd::io {

class NumbersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void decimalNumbersAreRead() {
    QVERIFY(parseNumber("1") == 1.0);
    QVERIFY(parseNumber("+1.5") == 1.5);
    QVERIFY(parseNumber("-.5e-1") == -0.05);
    QVERIFY(parseNumber("5.") == 5.0);
    QVERIFY(std::signbit(*parseNumber("-0")));
  }

  void theRestIsNoNumber() {
    for (const char* word :
         {"", "+", "-", ".", "+-1", "++1", "1,5", "0x10", "1.0f", "1e", "1 ", " 1", "1.#IND", "abc"}) {
      QVERIFY2(!parseNumber(word), word);
    }
    for (const char* word : {"", "+1", "1.0", "1e3", "99999999999999999999", "0x1", "1 "}) {
      QVERIFY2(!parseInteger(word), word);
    }
    QVERIFY(parseInteger("-12") == -12);
  }

  void numbersBeyondDoublesAreInfiniteOrZero() {
    QVERIFY(parseNumber("1e999") == std::numeric_limits<double>::infinity());
    QVERIFY(parseNumber("-1e999") == -std::numeric_limits<double>::infinity());
    QVERIFY(parseNumber("1" + std::string(400, '0')) == std::numeric_limits<double>::infinity());
    QVERIFY(parseNumber("-1e-999") == 0.0);
    QVERIFY(parseNumber("0." + std::string(400, '0') + "1") == 0.0);
    QVERIFY(std::isnan(*parseNumber("nan")));
    QVERIFY(std::isinf(*parseNumber("-inf")));
  }

  void writtenNumbersReadBackToTheLastBit() {
    for (const double value : {0.1, 1.0 / 3.0, 1e23, 5e-324, 1.7976931348623157e308, -123456.789}) {
      std::string text = "x";
      appendNumber(text, value);
      QVERIFY(parseNumber(text.substr(1)) == value);
    }
    std::string text;
    appendNumber(text, 0.5);
    appendInteger(text, -7);
    QCOMPARE(text, std::string("0.5-7"));
  }
};

const test::Registration<NumbersTest> registration;

}  // namespace pbffd::io

#include "numbers_test.moc"
