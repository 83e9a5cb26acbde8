#include "core/ffd/refinement/fitted_poses.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/ffd/weights/parameterization.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/bend.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {
namespace {

using test::Scene;

/// Balls on the surface, of alternating reach.
std::vector<ControlPoint> ballsOn(const RestMesh& mesh, int count, double radius) {
  std::vector<ControlPoint> points;
  for (int i = 0; i < count; ++i) {
    const Index vertex = static_cast<Index>(i) * mesh.vertexCount() / count;
    points.push_back(test::pointAt(0, mesh.positions().row(vertex), radius * mesh.diagonal(),
                                   i % 2 == 0 ? Reach::connected : Reach::all));
  }
  return points;
}

void bend(Scene& scene, double degrees) {
  for (Index i = 0; i < scene.set.levels[0].size(); ++i) {
    ControlPoint point = scene.set.levels[0][i];
    point.pose = moved(point.rest, test::bendAt(point.rest.center, scene.mesh->bounds(), degrees));
    scene.set.levels[0].replace(i, point);
  }
}

bool reachesAVertex(const RestMesh& mesh, const ControlPoint& point) {
  return !reachedVertices(mesh, point).vertices.empty();
}

}  // namespace

class FittedPosesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whereNothingMovedPosesAreTheRestFrames() {
    Scene scene(test::sphere());
    const auto fitted = fittedPoints(ballsOn(*scene.mesh, 12, 0.1), scene.mesh, scene.set, 0.0, {});
    QCOMPARE(fitted.change, 0.0);
    for (const ControlPoint& point : fitted.points) {
      QVERIFY(point.pose == point.rest);
    }
  }

  void whatIsFarFromAllThatMovedStaysAtRestToTheBit() {
    Scene scene(test::cylinder(4.0, 0.5, 60), 0);
    ControlPoint moved = test::pointAt(1, Vec3(4, 0, 0), 1.0);
    moved.pose.center += Vec3(0.5, 0.5, 0);
    scene.set.levels[0].append(moved);
    const auto fitted =
        fittedPoints({test::pointAt(0, Vec3(0.5, 0.5, 0), 0.6)}, scene.mesh, scene.set, 0.01, {});
    QVERIFY(fitted.points[0].pose == fitted.points[0].rest);
  }

  void affineDeformationIsMetExactly() {
    Scene scene(test::cylinder());
    Mat3 linear;
    linear << 1.2, 0.3, -0.1, 0.2, 0.7, 0.4, -0.3, 0.1, 1.5;
    const AffineMap map = makeMap(linear, Vec3(3, -2, 5));
    scene.poseBy(map);
    const double diagonal = scene.mesh->diagonal();
    const auto fitted =
        fittedPoints(ballsOn(*scene.mesh, 20, 0.1), scene.mesh, scene.set, 1e-12 * diagonal, {});
    QVERIFY(fitted.change < 1e-12 * diagonal);
    for (const ControlPoint& point : fitted.points) {
      QCOMPARE(point.rest.axes(0, 0), 0.1 * diagonal);
      QVERIFY((point.map() - map).cwiseAbs().maxCoeff() < 1e-11);
    }
  }

  void verticesStayWithinWhatIsAllowed_data() {
    QTest::addColumn<double>("share");
    QTest::newRow("a hundredth") << 0.01;
    QTest::newRow("a thousandth") << 0.001;
    QTest::newRow("a hundred thousandth") << 1e-5;
  }

  void verticesStayWithinWhatIsAllowed() {
    QFETCH(double, share);
    Scene scene(test::cylinder(4.0, 0.5, 60));
    bend(scene, 120.0);
    const double allowed = share * scene.mesh->diagonal();
    const auto fitted = fittedPoints(ballsOn(*scene.mesh, 20, 0.2), scene.mesh, scene.set, allowed, {});
    QVERIFY(fitted.change > 0.0);
    QVERIFY(fitted.change <= allowed);
    for (const ControlPoint& point : fitted.points) {
      QVERIFY(reachesAVertex(*scene.mesh, point));
      QVERIFY(point.strength > 0.0);
    }
  }

  void regionsBecomeSmallerOnlyWhereTheyMust() {
    Scene scene(test::cylinder(4.0, 0.5, 60), 0);
    // Only one end is deformed.
    ControlPoint point = test::pointAt(1, Vec3(4, 0, 0), 1.5);
    point.pose.axes = Scene::turnBy(Vec3(0, 0, 2)) * point.pose.axes;
    scene.set.levels[0].append(point);
    const std::vector<ControlPoint> made{test::pointAt(0, Vec3(3.4, 0.5, 0), 0.8),
                                         test::pointAt(0, Vec3(0.5, 0.5, 0), 0.8)};
    const auto fitted = fittedPoints(made, scene.mesh, scene.set, 0.005, {});
    QVERIFY(fitted.points[0].rest.axes(0, 0) < 0.8);
    QCOMPARE(fitted.points[1].rest.axes(0, 0), 0.8);
  }

  void regionWithoutVerticesFollowsThePlacesAround() {
    Scene scene(test::cylinder());
    const AffineMap map = makeMap(Scene::turnBy(Vec3(0.3, 0.4, 0.5)), Vec3(1, 2, 3));
    scene.poseBy(map);
    const auto fitted = fittedPoints({test::pointAt(0, Vec3(2, 0, 0), 0.05)}, scene.mesh, scene.set, 1e-9, {});
    QVERIFY((fitted.points[0].map() - map).cwiseAbs().maxCoeff() < 1e-11);
  }

  void sameBitsOnAnyNumberOfThreads() {
    Scene scene(test::fork());
    scene.poseAtRandom(0.1, true);
    const auto fitted = [&] {
      return fittedPoints(ballsOn(*scene.mesh, 30, 0.1), scene.mesh, scene.set, 0.01, {}).points;
    };
    const std::vector<ControlPoint> many = fitted();
    const ThreadLimit one(1);
    QVERIFY(fitted() == many);
  }

  void fittingCanBeCancelled() {
    Scene scene(test::sphere());
    scene.poseAtRandom();
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(fittedPoints(ballsOn(*scene.mesh, 4, 0.1), scene.mesh, scene.set, 0.01, progress),
                             Cancelled);
  }
};

const test::Registration<FittedPosesTest> registration;

}  // namespace pbffd

#include "fitted_poses_test.moc"
