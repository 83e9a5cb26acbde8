#include "ui/views/picking.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::ui {

class PickingTest : public QObject {
  Q_OBJECT

  /// Looks along -z at the origin from a distance of 10; a unit there is about 95 pixels.
  static Projection front() {
    Camera camera;
    camera.distance = 10.0;
    return camera.projection(800, 600, {Vec3::Zero(), 2.0, 6.0});
  }

 private Q_SLOTS:
  void pointInFrontComesBeforeTheOneBehind() {
    const std::vector<PickablePoint> points{{1, Vec3(0, 0, -1)}, {2, Vec3(0, 0, 1)}, {3, Vec3(2, 0, 0)}};
    QCOMPARE(pickPoints(points, front(), {400, 300}, 10.0), (std::vector<PointId>{2, 1}));
  }

  void pointUnderTheCursorComesBeforeANearerOneBesideIt() {
    const std::vector<PickablePoint> points{{1, Vec3(0, 0, 0)}, {2, Vec3(0.08, 0, 1)}};
    QCOMPARE(pickPoints(points, front(), {400, 300}, 10.0), (std::vector<PointId>{1, 2}));
  }

  void nothingIsPickedBeyondTheRadius() {
    const std::vector<PickablePoint> points{{1, Vec3(0.2, 0, 0)}};
    QVERIFY(pickPoints(points, front(), {400, 300}, 10.0).empty());
  }

  void pointsBehindTheEyeAreNeverPicked() {
    const std::vector<PickablePoint> points{{1, Vec3(0, 0, 20)}};
    QVERIFY(pickPoints(points, front(), {400, 300}, 1000.0).empty());
    QVERIFY(pickPointsIn(points, front(), QRectF(0, 0, 800, 600)).empty());
  }

  void boxTakesWhatProjectsIntoItInOrder() {
    const std::vector<PickablePoint> points{{7, Vec3(0, 0, -3)}, {5, Vec3(0.5, 0, 0)}, {6, Vec3(-2, 0, 0)}};
    const QRectF backwards(QPointF(460, 320), QPointF(380, 280));
    QCOMPARE(pickPointsIn(points, front(), backwards), (std::vector<PointId>{7, 5}));
  }

  void rayMeetsTheNearestTriangle() {
    std::vector<float> positions;
    std::vector<Index> triangles;
    for (int i = 0; i < 3; ++i) {
      const auto z = static_cast<float>(-i);
      positions.insert(positions.end(), {-1, -1, z, 3, -1, z, -1, 3, z});
      triangles.insert(triangles.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    const auto pick = pickSurface(positions, triangles, {Vec3(0, 0, 5), -Vec3::UnitZ()});
    QVERIFY(pick.has_value());
    QCOMPARE(pick->triangle, 0);
    QCOMPARE(pick->distance, 5.0);
    const auto fromBehind = pickSurface(positions, triangles, {Vec3(0, 0, -5), Vec3::UnitZ()});
    QCOMPARE(fromBehind->triangle, 2);
    QVERIFY(!pickSurface(positions, triangles, {Vec3(0, 0, 5), Vec3::UnitZ()}));
    QVERIFY(!pickSurface(positions, triangles, {Vec3(5, 5, 5), -Vec3::UnitZ()}));
    QVERIFY(!pickSurface({}, {}, {Vec3(5, 5, 5), -Vec3::UnitZ()}));
  }

  void lowestIndexCountsOnATie() {
    const std::vector<float> positions{-1, -1, 0, 3, -1, 0, -1, 3, 0};
    std::vector<Index> triangles;
    for (int i = 0; i < 20000; ++i) {
      triangles.insert(triangles.end(), {0, 1, 2});
    }
    QCOMPARE(pickSurface(positions, triangles, {Vec3(0, 0, 5), -Vec3::UnitZ()})->triangle, 0);
  }
};

const pbffd::test::Registration<PickingTest> registration;

}  // namespace pbffd::ui

#include "picking_test.moc"
