#include "ui/window/number_field.h"

#include "tests/support/shown_window.h"
#include "tests/support/test_main.h"
#include "ui/document/theme.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

namespace pbffd::test {

using ui::NumberField;
using ui::NumberInput;

class NumberFieldTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup();

  void typedSumsAreEntered();
  void factorsAreEnteredAsSuch();
  void differentValuesShowMixed();
  void aBadValueIsFramedAndDropped();
  void aValueOutOfRangeIsRefused();
  void escapeTakesTypingBack();
  void arrowKeysStep();
  void aDragScrubsAndShiftIsFine();
  void escapeInAScrubDropsIt();
  void aClickStartsTyping();
  void aScrubStopsAtTheEnds();
  void numbersHaveARealMinus();
  void aNumberThatIsTooLongLosesDecimalsNotItsEnd();

 private:
  void type(const QString& text);

  std::unique_ptr<ui::Theme> theme_;
  std::unique_ptr<QWidget> window_;
  QPushButton* other_ = nullptr;
  NumberField* field_ = nullptr;
  std::vector<NumberInput> entered_;
};

void NumberFieldTest::init() {
  theme_ = std::make_unique<ui::Theme>();
  // Another control has the focus at first.
  window_ = std::make_unique<QWidget>();
  other_ = new QPushButton(window_.get());
  other_->setGeometry(100, 0, 80, 26);
  field_ = new NumberField(*theme_, NumberField::Look{"axis.x", {}, {}}, window_.get());
  field_->setGeometry(0, 0, 80, 26);
  field_->setValue(2.0);
  field_->setStep(0.5);
  entered_.clear();
  connect(field_, &NumberField::entered, this, [this](const NumberInput& input) { entered_.push_back(input); });
  QVERIFY(showActive(*window_));
  other_->setFocus();
}

void NumberFieldTest::cleanup() {
  window_.reset();
  theme_.reset();
}

void NumberFieldTest::type(const QString& text) {
  if (field_->hasFocus()) {
    field_->selectAll();
  } else {
    QTest::mouseClick(field_, Qt::LeftButton);
  }
  QTest::keyClicks(field_, text);
  QTest::keyClick(field_, Qt::Key_Return);
}

void NumberFieldTest::typedSumsAreEntered() {
  type("1.2*3");
  QCOMPARE(entered_.size(), std::size_t{1});
  QVERIFY(entered_[0].kind == NumberInput::Kind::set);
  QCOMPARE(entered_[0].value, 1.2 * 3);
}

void NumberFieldTest::factorsAreEnteredAsSuch() {
  field_->setStandsForMany(true);
  type("*1.1");
  type("+0.2");
  QCOMPARE(entered_.size(), std::size_t{2});
  QVERIFY(entered_[0].kind == NumberInput::Kind::multiply);
  QVERIFY(entered_[1].kind == NumberInput::Kind::add);
}

void NumberFieldTest::differentValuesShowMixed() {
  field_->setMixed(1.5);
  QCOMPARE(field_->text(), QString("mixed"));
  type("4");
  QCOMPARE(entered_[0].appliedTo(field_->value()), 4.0);
}

void NumberFieldTest::aBadValueIsFramedAndDropped() {
  QSignalSpy rejected(field_, &NumberField::rejected);
  type("2*");
  QVERIFY(entered_.empty());
  QVERIFY(field_->property("bad").toBool());
  QVERIFY(!field_->toolTip().isEmpty());
  QVERIFY(!rejected.last().first().toString().isEmpty());
  field_->clearFocus();
  QVERIFY(!field_->property("bad").toBool());
  QCOMPARE(field_->text(), QString("2.000"));
  QVERIFY(entered_.empty());
}

void NumberFieldTest::aValueOutOfRangeIsRefused() {
  field_->setRange(0.0, 10.0);
  type("11");
  QVERIFY(entered_.empty());
  QVERIFY(field_->property("bad").toBool());
  type("10");
  QCOMPARE(entered_.size(), std::size_t{1});
}

void NumberFieldTest::escapeTakesTypingBack() {
  QTest::mouseClick(field_, Qt::LeftButton);
  QTest::keyClicks(field_, "77");
  QTest::keyClick(field_, Qt::Key_Escape);
  QCOMPARE(field_->text(), QString("2.000"));
  QVERIFY(entered_.empty());
}

void NumberFieldTest::arrowKeysStep() {
  QSignalSpy nudged(field_, &NumberField::nudged);
  QTest::mouseClick(field_, Qt::LeftButton);
  QTest::keyClick(field_, Qt::Key_Up);
  QTest::keyClick(field_, Qt::Key_Down, Qt::ShiftModifier);
  QCOMPARE(nudged.count(), 2);
  QCOMPARE(nudged[0][0].toDouble(), 0.5);
  QVERIFY(std::abs(nudged[1][0].toDouble() + 0.05) < 1e-12);
}

void NumberFieldTest::aDragScrubsAndShiftIsFine() {
  QSignalSpy scrubbed(field_, &NumberField::scrubbed);
  QSignalSpy ended(field_, &NumberField::scrubEnded);
  const QPoint start(40, 13);
  QTest::mousePress(field_, Qt::LeftButton, {}, start);
  QTest::mouseMove(field_, start + QPoint(2, 0));
  QCOMPARE(scrubbed.count(), 0);
  QTest::mouseMove(field_, start + QPoint(10, 0));
  QCOMPARE(scrubbed.last()[0].toDouble(), 5.0);
  QTest::mouseRelease(field_, Qt::LeftButton, {}, start + QPoint(10, 0));
  QCOMPARE(ended.count(), 1);
  QVERIFY(ended[0][0].toBool());
  QVERIFY(!field_->hasFocus());
}

void NumberFieldTest::escapeInAScrubDropsIt() {
  QSignalSpy ended(field_, &NumberField::scrubEnded);
  const QPoint start(40, 13);
  QTest::mousePress(field_, Qt::LeftButton, {}, start);
  QTest::mouseMove(field_, start + QPoint(20, 0));
  QTest::keyClick(field_, Qt::Key_Escape);
  QTest::mouseRelease(field_, Qt::LeftButton, {}, start + QPoint(20, 0));
  QCOMPARE(ended.count(), 1);
  QVERIFY(!ended[0][0].toBool());
}

void NumberFieldTest::aClickStartsTyping() {
  QTest::mouseClick(field_, Qt::LeftButton);
  QVERIFY(field_->hasFocus());
  QCOMPARE(field_->selectedText(), field_->text());
}

void NumberFieldTest::aScrubStopsAtTheEnds() {
  field_->setRange(0.0, 3.0);
  QSignalSpy scrubbed(field_, &NumberField::scrubbed);
  QTest::mousePress(field_, Qt::LeftButton, {}, {10, 13});
  QTest::mouseMove(field_, {70, 13});
  QCOMPARE(scrubbed.last()[0].toDouble(), 1.0);
  QTest::mouseRelease(field_, Qt::LeftButton, {}, {70, 13});
}

void NumberFieldTest::numbersHaveARealMinus() {
  QCOMPARE(NumberField::formatted(-0.3131, 3), QString(QChar(0x2212)) + "0.313");
  QCOMPARE(NumberField::formatted(-0.0001, 3), QString("0.000"));
}

void NumberFieldTest::aNumberThatIsTooLongLosesDecimalsNotItsEnd() {
  const QString minus = QChar(0x2212);
  field_->setValue(-242.0913);
  QCOMPARE(field_->text(), minus + "242.091");
  field_->resize(52, 26);
  QCOMPARE(field_->text(), minus + "242");
  QCOMPARE(field_->value(), -242.0913);
  field_->setValue(1.5);
  QVERIFY(field_->text().startsWith("1.5"));
  field_->setValue(-242.0913);
  field_->resize(80, 26);
  QCOMPARE(field_->text(), minus + "242.091");
}

const Registration<NumberFieldTest> registration;

}  // namespace pbffd::test

#include "number_field_test.moc"
