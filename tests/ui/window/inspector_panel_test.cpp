#include "ui/window/inspector_panel.h"

#include "tests/support/shown_window.h"
#include "tests/support/test_main.h"
#include "tests/ui/document/opened.h"
#include "ui/document/theme.h"
#include "ui/window/number_field.h"
#include "ui/window/point_selection.h"

#include <QCheckBox>
#include <QLabel>
#include <QtTest>

namespace pbffd::test {

using ui::NumberField;

class InspectorPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup();

  void withoutASelectionTheMeshIsShown();
  void aTypedPositionMovesThePoint();
  void manyPointsMoveByTheirMedian();
  void aScrubIsOneEntryAndEscapeDropsIt();
  void stepsOfOneRunAreOneEntry();
  void aRegionIsEditedAndUndone();
  void theTickEnablesAll();
  void aReasonStandsBelowABadValue();
  void influenceFollowsTheLevel();
  void everythingFitsTheNarrowestDock();

 private:
  NumberField& field(const QString& name) const;
  void type(const QString& name, const QString& text);
  QString textBeside(const QString& label) const;
  const ControlPoint& point(int place) const { return document_->shown().controls.finest()[place]; }

  QTemporaryDir folder_;
  std::unique_ptr<ui::Theme> theme_;
  std::unique_ptr<ui::Document> document_;
  std::unique_ptr<ui::InspectorPanel> panel_;
};

void InspectorPanelTest::init() {
  theme_ = std::make_unique<ui::Theme>();
  document_ = std::make_unique<ui::Document>();
  panel_ = std::make_unique<ui::InspectorPanel>(*document_, *theme_);
  panel_->resize(308, 700);
  QVERIFY(showActive(*panel_));
  QVERIFY(openShape(*document_, folder_));
}

void InspectorPanelTest::cleanup() {
  panel_.reset();
  document_.reset();
  theme_.reset();
}

void InspectorPanelTest::everythingFitsTheNarrowestDock() {
  constexpr int narrowest = 280;
  document_->selection().replace(firstPoints(*document_, 3));
  QVERIFY2(panel_->widget()->minimumSizeHint().width() <= narrowest,
           qPrintable(QString::number(panel_->widget()->minimumSizeHint().width())));
}

NumberField& InspectorPanelTest::field(const QString& name) const {
  for (NumberField* each : panel_->findChildren<NumberField*>()) {
    if (each->accessibleName() == name) {
      return *each;
    }
  }
  qFatal("no field %s", qPrintable(name));
}

void InspectorPanelTest::type(const QString& name, const QString& text) {
  QTest::mouseClick(&field(name), Qt::LeftButton);
  QTest::keyClicks(&field(name), text);
  QTest::keyClick(&field(name), Qt::Key_Return);
}

/// The labels that are shown, in reading order: the one after `label`.
QString InspectorPanelTest::textBeside(const QString& label) const {
  bool isNext = false;
  for (const QLabel* each : panel_->findChildren<QLabel*>()) {
    if (isNext && each->isVisible()) {
      return each->text();
    }
    isNext |= each->isVisible() && each->text() == label;
  }
  return {};
}

void InspectorPanelTest::withoutASelectionTheMeshIsShown() {
  QVERIFY(field("Position X").isHidden() || !field("Position X").isVisible());
  const qint64 vertices = document_->shown().mesh->vertexCount();
  bool isShown = false;
  for (const QLabel* label : panel_->findChildren<QLabel*>()) {
    isShown |= label->isVisible() && label->accessibleName() == "Vertices" &&
               label->text().remove(u',').toLongLong() == vertices;
  }
  QVERIFY(isShown);
}

void InspectorPanelTest::aTypedPositionMovesThePoint() {
  document_->selection().replace(firstPoints(*document_, 1));
  type("Position Y", "0.75");
  QCOMPARE(point(0).pose.center.y(), 0.75);
  QCOMPARE(field("Position Y").value(), 0.75);
  QCOMPARE(document_->history().count(), 2);
  QVERIFY(document_->history().undoText().startsWith("Move "));
  document_->undo();
  QCOMPARE(point(0).pose.center.y(), point(0).rest.center.y());
}

void InspectorPanelTest::manyPointsMoveByTheirMedian() {
  document_->selection().replace(firstPoints(*document_, 3));
  const Vec3 apart = point(1).pose.center - point(0).pose.center;
  type("From rest Z", "0.5");
  for (int place = 0; place < 3; ++place) {
    QVERIFY(std::abs(point(place).pose.center.z() - point(place).rest.center.z() - 0.5) < 1e-12);
  }
  QVERIFY((point(1).pose.center - point(0).pose.center - apart).norm() < 1e-12);
}

void InspectorPanelTest::aScrubIsOneEntryAndEscapeDropsIt() {
  document_->selection().replace(firstPoints(*document_, 1));
  NumberField& x = field("Position X");
  const double start = point(0).pose.center.x();
  const double step = ui::stepFor(document_->shown().mesh->diagonal());
  const QPoint press(20, 13);
  QTest::mousePress(&x, Qt::LeftButton, {}, press);
  for (int pixels = 5; pixels <= 30; pixels += 5) {
    QTest::mouseMove(&x, press + QPoint(pixels, 0));
    QCoreApplication::processEvents();
  }
  QTest::mouseRelease(&x, Qt::LeftButton, {}, press + QPoint(30, 0));
  QVERIFY(std::abs(point(0).pose.center.x() - start - 30 * step) < 1e-12);
  QCOMPARE(document_->history().count(), 2);

  QTest::mousePress(&x, Qt::LeftButton, {}, press);
  QTest::mouseMove(&x, press + QPoint(25, 0));
  QTest::keyClick(&x, Qt::Key_Escape);
  QTest::mouseRelease(&x, Qt::LeftButton, {}, press + QPoint(25, 0));
  QVERIFY(std::abs(point(0).pose.center.x() - start - 30 * step) < 1e-12);
  QCOMPARE(document_->history().count(), 2);
}

void InspectorPanelTest::stepsOfOneRunAreOneEntry() {
  document_->selection().replace(firstPoints(*document_, 1));
  NumberField& x = field("Position X");
  QTest::mouseClick(&x, Qt::LeftButton);
  for (int press = 0; press < 4; ++press) {
    QTest::keyClick(&x, Qt::Key_Up);
  }
  QCOMPARE(document_->history().count(), 2);
}

void InspectorPanelTest::aRegionIsEditedAndUndone() {
  document_->selection().replace(firstPoints(*document_, 1));
  const Frame before = point(0).rest;
  type("Semi-axes b", "*1.5");
  QVERIFY(std::abs(point(0).rest.axes.col(1).norm() - 1.5 * before.axes.col(1).norm()) < 1e-12);
  QCOMPARE(point(0).rest.axes.col(0).norm(), before.axes.col(0).norm());
  document_->undo();
  QVERIFY(point(0).rest == before);
}

void InspectorPanelTest::theTickEnablesAll() {
  document_->selection().replace(firstPoints(*document_, 3));
  QVERIFY(document_->perform(Enable{{std::nullopt, {firstPoints(*document_, 1).front()}}, false}));
  auto* tick = panel_->findChild<QCheckBox*>();
  QCOMPARE(tick->checkState(), Qt::PartiallyChecked);
  QCOMPARE(tick->text(), QString("2 of 3"));
  QTest::mouseClick(tick, Qt::LeftButton, {}, {8, tick->height() / 2});
  QVERIFY(point(0).enabled && point(1).enabled && point(2).enabled);
  QCOMPARE(tick->text(), QString("all 3"));
}

void InspectorPanelTest::aReasonStandsBelowABadValue() {
  document_->selection().replace(firstPoints(*document_, 1));
  type("Semi-axes a", "-1");
  bool isSaid = false;
  for (const QLabel* label : panel_->findChildren<QLabel*>()) {
    isSaid |= label->isVisible() && label->property("role") == "bad" && !label->text().isEmpty();
  }
  QVERIFY(isSaid);
  QCOMPARE(document_->history().count(), 1);
}

void InspectorPanelTest::influenceFollowsTheLevel() {
  document_->selection().replace(firstPoints(*document_, 1));
  QCoreApplication::processEvents();
  QVERIFY(!textBeside("Vertices reached").isEmpty());
  document_->selection().setLevel(1);
  document_->selection().replace({document_->shown().controls.levels[0][0].id});
  QCoreApplication::processEvents();
  QVERIFY(textBeside("Points of level 2 reached").endsWith("of 40"));
}

const Registration<InspectorPanelTest> registration;

}  // namespace pbffd::test

#include "inspector_panel_test.moc"
