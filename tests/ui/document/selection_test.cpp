#include "ui/document/selection.h"

#include "tests/support/test_main.h"

#include <QSignalSpy>
#include <QtTest>

namespace pbffd::test {

using ui::Selection;
using Ids = std::vector<PointId>;

class SelectionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theLastOneIsActive();
  void eachLevelKeepsItsOwn();
  void addingKeepsTheOrderAndNoDuplicates();
  void toggleAddsAndRemoves();
  void nothingNewIsNotAnnounced();
  void lostPointsAreForgottenOnEveryLevel();
  void coarserLevelsComeAndGo();
  void resetForgetsAll();
};

void SelectionTest::theLastOneIsActive() {
  Selection selection;
  QCOMPARE(selection.active(), PointId{0});
  selection.replace({3, 5, 4});
  QCOMPARE(selection.active(), PointId{4});
}

void SelectionTest::eachLevelKeepsItsOwn() {
  Selection selection;
  selection.replace({1, 2});
  selection.setLevel(2);
  QVERIFY(selection.isEmpty());
  selection.replace({7});
  selection.setLevel(1);
  QCOMPARE(selection.points(), Ids({1, 2}));
}

void SelectionTest::addingKeepsTheOrderAndNoDuplicates() {
  Selection selection;
  selection.replace({5, 3});
  selection.add({3, 9, 9, 1});
  QCOMPARE(selection.points(), Ids({5, 3, 9, 1}));
  selection.remove({3, 42});
  QCOMPARE(selection.points(), Ids({5, 9, 1}));
}

void SelectionTest::toggleAddsAndRemoves() {
  Selection selection;
  selection.toggle(4);
  QVERIFY(selection.contains(4));
  selection.toggle(4);
  QVERIFY(selection.isEmpty());
}

void SelectionTest::nothingNewIsNotAnnounced() {
  Selection selection;
  selection.replace({1});
  QSignalSpy changed(&selection, &Selection::changed);
  selection.replace({1});
  selection.add({1});
  selection.remove({2});
  selection.setLevel(1);
  QCOMPARE(changed.count(), 0);
}

void SelectionTest::lostPointsAreForgottenOnEveryLevel() {
  Selection selection;
  selection.replace({1, 2});
  selection.setLevel(2);
  selection.replace({10, 11});
  selection.keepOnly([](int level, PointId point) { return level == 1 ? point == 2 : point == 10; });
  QCOMPARE(selection.points(), Ids({10}));
  selection.setLevel(1);
  QCOMPARE(selection.points(), Ids({2}));
}

void SelectionTest::coarserLevelsComeAndGo() {
  Selection selection;
  selection.replace({1});
  selection.setLevel(2);
  selection.replace({2});
  selection.renumberLevels(1);
  QCOMPARE(selection.level(), 3);
  QCOMPARE(selection.points(), Ids({2}));
  selection.setLevel(2);
  selection.renumberLevels(-2);
  QCOMPARE(selection.level(), 1);
  QCOMPARE(selection.points(), Ids({2}));
}

void SelectionTest::resetForgetsAll() {
  Selection selection;
  selection.replace({1});
  selection.reset(3);
  QCOMPARE(selection.level(), 3);
  selection.setLevel(1);
  QVERIFY(selection.isEmpty());
}

const Registration<SelectionTest> registration;

}  // namespace pbffd::test

#include "selection_test.moc"
