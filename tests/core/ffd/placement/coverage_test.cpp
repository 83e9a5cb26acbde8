#include "core/ffd/placement/coverage.h"
#include "core/base/error.h"
#include "core/ffd/weights/parameterization.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace pbffd {
namespace {

ControlPoint ball(const Vec3& center, double radius, Reach reach = Reach::connected) {
  ControlPoint point;
  point.rest = {center, radius * Mat3::Identity()};
  point.pose = point.rest;
  point.reach = reach;
  return point;
}

std::vector<bool> reachedFlags(const RestMesh& mesh, const std::vector<ControlPoint>& points) {
  std::vector<bool> flags(static_cast<std::size_t>(mesh.vertexCount()), false);
  for (const ControlPoint& point : points) {
    for (const Index vertex : reachedVertices(mesh, point).vertices) {
      flags[static_cast<std::size_t>(vertex)] = true;
    }
  }
  return flags;
}

}  // namespace

class CoverageTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void coveredMeshStaysAsItIs() {
    const RestMesh mesh(test::sphere());
    std::vector<ControlPoint> points{ball(Vec3::Zero(), 1.5)};
    QCOMPARE(growCoverage(points, mesh, {}), 0);
    QVERIFY(points[0].rest.axes == 1.5 * Mat3::Identity());
  }

  void regionThatTouchesNothingGrowsToTheNearestVertex() {
    const RestMesh mesh(test::sphere());
    std::vector<ControlPoint> points{ball(Vec3::Zero(), 1.5), ball(Vec3(0.5, 0, 0), 0.1)};
    QCOMPARE(growCoverage(points, mesh, {}), 1);
    // The pole at (1, 0, 0) is half away: it comes to lie at 0.8 of the way to the border.
    QVERIFY(std::abs(points[1].rest.axes(0, 0) - 0.5 / 0.8) < 1e-12);
    QVERIFY(points[1].pose == points[1].rest);
  }

  void everyVertexIsTakenIn() {
    const RestMesh mesh(test::cylinder());
    std::vector<ControlPoint> points{ball(Vec3(0.5, 0, 0), 0.6), ball(Vec3(3.5, 0, 0), 0.6)};
    growCoverage(points, mesh, {});
    const std::vector<bool> flags = reachedFlags(mesh, points);
    QVERIFY(std::find(flags.begin(), flags.end(), false) == flags.end());
    // The nearer one grew in each half; neither swallows the bar.
    QVERIFY(points[0].rest.axes(0, 0) < 3.0 && points[1].rest.axes(0, 0) < 3.0);
  }

  void connectedRegionGrowsUntilTheVertexIsJoinedToIt() {
    // The point beside one arm holds the other arm only once the block that joins them is inside.
    const RestMesh mesh(test::fork());
    std::vector<ControlPoint> points{ball(mesh.positions().row(0).transpose(), 0.1)};
    growCoverage(points, mesh, {});
    const std::vector<bool> flags = reachedFlags(mesh, points);
    QVERIFY(std::find(flags.begin(), flags.end(), false) == flags.end());
  }

  void tinyRegionGrowsAsFarAsItMust() {
    // Two arms: what is near to the point lies far off along the surface.
    const RestMesh mesh(test::fork());
    std::vector<ControlPoint> points{ball(mesh.positions().row(0).transpose(), 1e-9)};
    growCoverage(points, mesh, {});
    const std::vector<bool> flags = reachedFlags(mesh, points);
    QVERIFY(std::find(flags.begin(), flags.end(), false) == flags.end());
  }

  void verticesWithoutFacesAreNoneToTouch() {
    Mesh shape = test::sphere();
    shape.positions.conservativeResize(shape.positions.rows() + 1, 3);
    shape.positions.bottomRows(1) << 1.3, 0, 0;
    const RestMesh mesh(shape);
    // One region holds the stray vertex, one would find it the nearest.
    std::vector<ControlPoint> points{ball(Vec3::Zero(), 1.5), ball(Vec3(1.3, 0, 0), 0.1),
                                     ball(Vec3(1.4, 0, 0), 0.05)};
    QCOMPARE(growCoverage(points, mesh, {}), 2);
    QVERIFY(std::abs(points[1].rest.axes(0, 0) - 0.3 / 0.8) < 1e-12);
    QVERIFY(std::abs(points[2].rest.axes(0, 0) - 0.4 / 0.8) < 1e-12);
  }

  void isolatedVerticesDoNotCount() {
    Mesh shape = test::sphere();
    shape.positions.conservativeResize(shape.positions.rows() + 1, 3);
    shape.positions.bottomRows(1) << 50, 50, 50;
    const RestMesh mesh(shape);
    std::vector<ControlPoint> points{ball(Vec3::Zero(), 1.5)};
    QCOMPARE(growCoverage(points, mesh, {}), 0);
  }

  void noPointsAreNoError() {
    const RestMesh mesh(test::sphere());
    std::vector<ControlPoint> none;
    QCOMPARE(growCoverage(none, mesh, {}), 0);
  }

  void cancelStopsIt() {
    const RestMesh mesh(test::sphere());
    std::vector<ControlPoint> points{ball(Vec3::Zero(), 0.1)};
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(growCoverage(points, mesh, progress), Cancelled);
  }
};

const test::Registration<CoverageTest> registration;

}  // namespace pbffd

#include "coverage_test.moc"
