#include "ui/views/frame_pace.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::ui {

class FramePaceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void oneSlowFrameSaysNothing() {
    FramePace pace;
    QVERIFY(!pace.isTooSlow());
    pace.wholeDrawn(0.5, false);  // the first: everything goes to the graphics card
    QVERIFY(!pace.isTooSlow());
    pace.wholeDrawn(0.01, false);
    pace.wholeDrawn(0.2, false);
    QVERIFY(!pace.isTooSlow());
    pace.wholeDrawn(0.1, false);
    QVERIFY(pace.isTooSlow());
  }

  void framesOfADragCountByThemselves() {
    FramePace pace;
    for (int i = 0; i < 2; ++i) {
      pace.wholeDrawn(0.01, false);
      pace.wholeDrawn(0.06, true);
    }
    QVERIFY(pace.isTooSlow());
    // Fast frames at rest do not make the next drag start with slow ones.
    pace.wholeDrawn(0.01, false);
    pace.wholeDrawn(0.01, false);
    QVERIFY(pace.isTooSlow());
    pace.forget();
    QVERIFY(!pace.isTooSlow());
  }

  void thirtyFramesASecondAreEnough() {
    FramePace pace;
    pace.wholeDrawn(0.033, true);
    pace.wholeDrawn(0.033, true);
    QVERIFY(!pace.isTooSlow());
    pace.wholeDrawn(0.034, true);
    pace.wholeDrawn(0.034, true);
    QVERIFY(pace.isTooSlow());
  }

  void standInTakesHalfOfAFrame() {
    FramePace pace;
    pace.wholeDrawn(0.2, false);
    pace.wholeDrawn(0.2, false);
    const Index wanted = pace.trianglesWanted(2'000'000);
    QVERIFY(wanted > 160'000 && wanted < 170'000);
  }

  void standInShrinksWhereItIsSlowToo() {
    FramePace pace;
    pace.wholeDrawn(0.2, false);
    pace.wholeDrawn(0.2, false);
    const Index first = pace.trianglesWanted(2'000'000);
    pace.standInDrawn(0.05, first);
    QCOMPARE(pace.trianglesWanted(2'000'000), first);
    pace.standInDrawn(0.05, first);
    const Index second = pace.trianglesWanted(2'000'000);
    QCOMPARE(second, first / 2);
    // The other one is judged anew; that it is fast does not make the first one fast.
    pace.standInDrawn(0.02, second);
    pace.standInDrawn(0.02, second);
    QCOMPARE(pace.trianglesWanted(2'000'000), second);
    pace.standInDrawn(0.05, second);
    pace.standInDrawn(0.05, second);
    QCOMPARE(pace.trianglesWanted(2'000'000), std::max(second / 2, 50'000));
  }

  void standInGrowsWhenTheMachineIsQuietAgain() {
    FramePace pace;
    pace.wholeDrawn(0.4, false);
    pace.wholeDrawn(0.4, false);
    const Index busy = pace.trianglesWanted(2'000'000);
    pace.standInDrawn(0.05, busy);
    pace.standInDrawn(0.05, busy);
    QCOMPARE(pace.trianglesWanted(2'000'000), std::max(busy / 2, 50'000));
    pace.wholeDrawn(0.1, false);
    pace.wholeDrawn(0.1, false);
    QVERIFY(pace.trianglesWanted(2'000'000) > 3 * busy);
  }

  void smallMeshesHaveNone() {
    QVERIFY(!FramePace::isLarge(100'000));
    QVERIFY(FramePace::isLarge(100'001));
  }

  void standInIsNeitherTinyNorMostOfTheMesh() {
    FramePace slow;
    slow.wholeDrawn(10.0, false);
    slow.wholeDrawn(10.0, false);
    QCOMPARE(slow.trianglesWanted(1'000'000), 50'000);
    QCOMPARE(slow.trianglesWanted(110'000), 50'000);
    FramePace quick;
    quick.wholeDrawn(0.035, false);
    quick.wholeDrawn(0.035, false);
    const Index wanted = quick.trianglesWanted(3'000'000);
    QVERIFY(wanted > 1'400'000 && wanted < 1'500'000);
  }
};

const pbffd::test::Registration<FramePaceTest> registration;

}  // namespace pbffd::ui

#include "frame_pace_test.moc"
