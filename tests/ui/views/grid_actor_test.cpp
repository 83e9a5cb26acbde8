#include "ui/views/grid_actor.h"
#include "tests/support/test_main.h"
#include "ui/views/round_numbers.h"

#include <QtTest>

#include <cmath>
#include <limits>

namespace pbffd::ui {

class GridActorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void spacingIsOneTwoOrFiveOfAPowerOfTen() {
    QCOMPARE(roundedDown125(1.0), 1.0);
    QCOMPARE(roundedDown125(1.99), 1.0);
    QCOMPARE(roundedDown125(2.0), 2.0);
    QCOMPARE(roundedDown125(4.9), 2.0);
    QCOMPARE(roundedDown125(73.0), 50.0);
    QVERIFY(std::abs(roundedDown125(0.1) - 0.1) < 1e-15);
    QVERIFY(std::abs(roundedDown125(0.0031) - 0.002) < 1e-15);
    QCOMPARE(roundedDown125(0.0), 0.0);
    QCOMPARE(roundedDown125(-1.0), 0.0);
    QCOMPARE(roundedDown125(std::numeric_limits<double>::infinity()), 0.0);
  }

  void linesLieUnderTheMeshOnMultiplesOfTheSpacing() {
    Bounds bounds;
    bounds.low = Vec3(3.1, -2, 7);
    bounds.high = Vec3(9, 4, 9);
    const Vec3 origin = bounds.center();
    const Grid grid = makeGrid(bounds, origin, {});
    QCOMPARE(grid.spacing, 0.5);
    for (const Stroke& stroke : grid.strokes) {
      const Vec3 from = stroke.from + origin;
      QVERIFY(std::abs(from.y() - bounds.low.y()) < 1e-12);
      const Vec3 along = stroke.to - stroke.from;
      const double across = std::abs(along.x()) > std::abs(along.z()) ? from.z() : from.x();
      QVERIFY(std::abs(across / grid.spacing - std::round(across / grid.spacing)) < 1e-9);
    }
  }

  void aPointHasNoGrid() { QVERIFY(makeGrid({}, Vec3::Zero(), {}).strokes.empty()); }
};

const pbffd::test::Registration<GridActorTest> registration;

}  // namespace pbffd::ui

#include "grid_actor_test.moc"
