#include "ui/document/expression.h"

#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::test {

using ui::evaluateExpression;
using ui::NumberInput;
using ui::parseNumberInput;

class ExpressionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sumsHaveTheirValue_data();
  void sumsHaveTheirValue();
  void whatIsNoSumHasNone_data();
  void whatIsNoSumHasNone();
  void deepBracketsDoNotOverflow();
  void factorsAndTermsActOnThePresentValue();
};

void ExpressionTest::sumsHaveTheirValue_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<double>("value");
  QTest::newRow("number") << "1.25" << 1.25;
  QTest::newRow("comma") << "1,25" << 1.25;
  QTest::newRow("product before sum") << "1+2*3" << 7.0;
  QTest::newRow("brackets") << "(1+2)*3" << 9.0;
  QTest::newRow("from the left") << "8/4/2" << 1.0;
  QTest::newRow("signs") << "--2-+1" << 1.0;
  QTest::newRow("spaces") << "  1.2 * 3 " << 1.2 * 3;
  QTest::newRow("power of ten") << "2e-3" << 2e-3;
  QTest::newRow("real minus") << QString(QChar(0x2212)) + "4" << -4.0;
  QTest::newRow("times sign") << QString("2") + QChar(0x00d7) + "4" << 8.0;
  QTest::newRow("open end") << ".5" << 0.5;
}

void ExpressionTest::sumsHaveTheirValue() {
  QFETCH(QString, text);
  QFETCH(double, value);
  const auto result = evaluateExpression(text);
  QVERIFY(result.has_value());
  QCOMPARE(*result, value);
}

void ExpressionTest::whatIsNoSumHasNone_data() {
  QTest::addColumn<QString>("text");
  for (const char* text :
       {"", " ", "abc", "1+", "(1", "1)", "1..2", "1 2x", "1/0", "0/0", "e5", "nan", "1e999", "*2"}) {
    QTest::newRow(text) << text;
  }
}

void ExpressionTest::whatIsNoSumHasNone() {
  QFETCH(QString, text);
  QVERIFY(!evaluateExpression(text).has_value());
}

void ExpressionTest::deepBracketsDoNotOverflow() {
  QVERIFY(!evaluateExpression(QString(100000, u'(')).has_value());
  QVERIFY(!evaluateExpression(QString(100000, u'-') + "1").has_value());
}

void ExpressionTest::factorsAndTermsActOnThePresentValue() {
  QCOMPARE(parseNumberInput(u"*1.5", false)->appliedTo(4.0), 6.0);
  QCOMPARE(parseNumberInput(u"/2", false)->appliedTo(4.0), 2.0);
  QCOMPARE(parseNumberInput(u"+0.5", true)->appliedTo(4.0), 4.5);
  QCOMPARE(parseNumberInput(u"+0.5", false)->appliedTo(4.0), 0.5);
  QCOMPARE(parseNumberInput(u"-0.5", true)->appliedTo(4.0), -0.5);
  QVERIFY(!parseNumberInput(u"/0", false).has_value());
  QVERIFY(!parseNumberInput(u"*", false).has_value());
}

const Registration<ExpressionTest> registration;

}  // namespace pbffd::test

#include "expression_test.moc"
