#include "core/base/figures.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class FiguresTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void thousandsAreApart() {
    QCOMPARE(counted(0), std::string("0"));
    QCOMPARE(counted(999), std::string("999"));
    QCOMPARE(counted(2903), std::string("2,903"));
    QCOMPARE(counted(1599008), std::string("1,599,008"));
  }

  void threeDigitsCount() {
    const auto says = [](double value, const char* text) {
      QVERIFY2(figures(value) == text, figures(value).c_str());
    };
    says(0.0, "0");
    says(-0.0, "0");
    says(0.35, "0.35");
    says(-0.12345, "−0.123");
    says(999.4, "999");
    says(999.6, "1,000");
    says(-1234.5, "−1,230");
    says(23456789.0, "23,500,000");
    says(2e12, "2e+12");
    says(-2e-7, "−2e−07");
  }
};

const test::Registration<FiguresTest> registration;

}  // namespace pbffd

#include "figures_test.moc"
