#include "ui/controllers/drag_math.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>
#include <numbers>

namespace pbffd::ui {

class DragMathTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void lineIsFollowedWhereTheRayPassesIt() {
    const Guide line{Vec3(1, 2, 3), Vec3::UnitY()};
    const PickRay ray{Vec3(6, 7.5, 3), -Vec3::UnitX()};
    QCOMPARE(nearestOnLine(ray, line).value(), 5.5);
    const PickRay skew{Vec3(1, 0, 13), Vec3(0, 0.6, -0.8)};
    QVERIFY(std::abs(nearestOnLine(skew, line).value() - 5.5) < 1e-12);
  }

  void rayAlongTheLineSaysNothing() {
    QVERIFY(!nearestOnLine({Vec3(0, 9, 0), -Vec3::UnitY()}, {Vec3::Zero(), Vec3::UnitY()}));
  }

  void planeIsMetInFrontOnly() {
    const Guide plane{Vec3(0, 0, 1), Vec3::UnitZ()};
    const auto at = meetsPlane({Vec3(2, 3, 5), -Vec3::UnitZ()}, plane);
    QCOMPARE(at.value(), Vec3(2, 3, 1));
    QVERIFY(!meetsPlane({Vec3(2, 3, 5), Vec3::UnitZ()}, plane));
    QVERIFY(!meetsPlane({Vec3(2, 3, 5), Vec3::UnitX()}, plane));
  }

  void anglesAreRightHanded() {
    const Guide plane{Vec3(1, 1, 1), Vec3::UnitZ()};
    const double quarter = std::numbers::pi / 2;
    QVERIFY(std::abs(angleBetween(plane, Vec3(3, 1, 1), Vec3(1, 4, 1)) - quarter) < 1e-12);
    QVERIFY(std::abs(angleBetween(plane, Vec3(1, 4, 1), Vec3(3, 1, 1)) + quarter) < 1e-12);
    QCOMPARE(angleBetween(plane, Vec3(1, 1, 1), Vec3(3, 1, 1)), 0.0);
  }

  void snappingGoesToTheNearestStep() {
    QCOMPARE(snapped(0.74, 0.5), 0.5);
    QCOMPARE(snapped(-0.76, 0.5), -1.0);
    QCOMPARE(snapped(0.74, 0.0), 0.74);
    QVERIFY(std::abs(moveStep(10.4) - 0.1) < 1e-15);
    QVERIFY(std::abs(moveStep(7.0) - 0.05) < 1e-15);
  }
};

const pbffd::test::Registration<DragMathTest> registration;

}  // namespace pbffd::ui

#include "drag_math_test.moc"
