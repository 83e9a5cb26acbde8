#include "core/mesh/winding_number.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

namespace pbffd {
namespace {

/// Points all over a box half again as large as the mesh.
Points scattered(const Mesh& mesh, Index count) {
  const Bounds bounds = boundsOf(mesh.positions);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-0.25, 1.25);
  Points points(count, 3);
  for (Index i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      points(i, axis) = bounds.low[axis] + share(random) * (bounds.high[axis] - bounds.low[axis]);
    }
  }
  return points;
}

double greatestDeviation(const Mesh& mesh) {
  const Triangles triangles = triangulate(mesh.positions, mesh.faces);
  const WindingNumber fast(mesh.positions, triangles.vertices());
  double deviation = 0.0;
  const Points points = scattered(mesh, 2000);
  for (Index i = 0; i < points.rows(); ++i) {
    const Vec3 point = points.row(i);
    const double exact = exactWindingNumber(mesh.positions, triangles.vertices(), point);
    deviation = std::max(deviation, std::abs(fast.at(point) - exact));
  }
  return deviation;
}

}  // namespace

class WindingNumberTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isOneInsideAndZeroOutsideAClosedMesh() {
    const Mesh mesh = test::cube();
    const Triangles triangles = triangulate(mesh.positions, mesh.faces);
    const WindingNumber winding(mesh.positions, triangles.vertices());
    QVERIFY(std::abs(winding.at({0.1, 0.2, -0.3}) - 1.0) < 1e-5);
    QVERIFY(std::abs(winding.at({0.6, 0.0, 0.0})) < 1e-5);
    QVERIFY(std::abs(winding.at({0.49999, 0.49999, 0.49999}) - 1.0) < 1e-5);
    QVERIFY(winding.isInside({0.1, 0.2, -0.3}));
    QVERIFY(!winding.isInside({100.0, 0.0, 0.0}));
  }

  void countsNestedShells() {
    const Mesh mesh = test::merged(test::cube(), test::placedAt(test::cube(), 3.0, Vec3::Zero()));
    const Triangles triangles = triangulate(mesh.positions, mesh.faces);
    QVERIFY(std::abs(exactWindingNumber(mesh.positions, triangles.vertices(), {0.1, 0.0, 0.0}) - 2.0) < 1e-12);
    QVERIFY(std::abs(exactWindingNumber(mesh.positions, triangles.vertices(), {1.1, 0.0, 0.0}) - 1.0) < 1e-12);
  }

  void isAHalfInFrontOfASheetFromBehind() {
    // Close to a sheet, half of all directions meet it, from behind.
    const Mesh mesh = test::sheet(10);
    const Triangles triangles = triangulate(mesh.positions, mesh.faces);
    const double above = exactWindingNumber(mesh.positions, triangles.vertices(), {0.0, 0.03, 1e-9});
    const double below = exactWindingNumber(mesh.positions, triangles.vertices(), {0.0, 0.03, -1e-9});
    QVERIFY(std::abs(std::abs(above) - 0.5) < 1e-6);
    QVERIFY(std::abs(above + below) < 1e-6);
  }

  void fastAgreesWithExact() {
    QVERIFY(greatestDeviation(test::sphere(40, 80)) < 0.05);
    QVERIFY(greatestDeviation(test::fork()) < 0.05);
    QVERIFY(greatestDeviation(test::sheet(30)) < 0.05);
  }

  void decidesLikeExactBesideAClosedSurface() {
    for (const Mesh& mesh : {test::sphere(30, 60), test::fork()}) {
      const Triangles triangles = triangulate(mesh.positions, mesh.faces);
      const WindingNumber fast(mesh.positions, triangles.vertices());
      // Along the normals, as near as a ten-thousandth.
      for (Index t = 0; t < triangles.size(); t += 7) {
        const auto at = [&](int k) -> Vec3 { return mesh.positions.row(triangles.vertices()[3 * t + k]); };
        const Vec3 center = (at(0) + at(1) + at(2)) / 3.0;
        const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
        for (const double distance : {-1e-2, -1e-4, 1e-4, 1e-2}) {
          const Vec3 point = center + distance * normal;
          QCOMPARE(fast.isInside(point), exactWindingNumber(mesh.positions, triangles.vertices(), point) > 0.5);
        }
      }
    }
  }

  void decidesRightDownToAMillionthBesideTheSurface() {
    // Differences are taken before anything is rounded to single precision, so an offset of the mesh costs no
    // more than what its coordinates have lost already.
    for (const double offset : {0.0, 1e8}) {
      const Mesh mesh = test::placedAt(test::sphere(30, 60), 1.0, Vec3::Constant(offset));
      const Triangles triangles = triangulate(mesh.positions, mesh.faces);
      const WindingNumber fast(mesh.positions, triangles.vertices());
      for (Index t = 0; t < triangles.size(); ++t) {
        const auto at = [&](int k) -> Vec3 { return mesh.positions.row(triangles.vertices()[3 * t + k]); };
        const Vec3 center = at(0) + ((at(1) - at(0)) + (at(2) - at(0))) / 3.0;
        const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
        // Coordinates at 1e8 are 1.5e-8 apart.
        QVERIFY(fast.isInside(center - 1e-6 * normal));
        QVERIFY(!fast.isInside(center + 1e-6 * normal));
      }
    }
  }

  void nearTrianglesAddUpToSinglePrecision() {
    // What far parts of the surface leave out is more by far; the decision lies at one half.
    const Mesh cube = test::cube();
    const Triangles triangles = triangulate(cube.positions, cube.faces);
    const WindingNumber fast(cube.positions, triangles.vertices());
    const Points points = scattered(cube, 2000);
    for (Index i = 0; i < points.rows(); ++i) {
      const double exact = exactWindingNumber(cube.positions, triangles.vertices(), points.row(i));
      QVERIFY(std::abs(exact - std::round(exact)) < 1e-12);
      QVERIFY(std::abs(fast.at(points.row(i)) - exact) < 1e-5);
    }
  }

  void holdsFarFromTheOriginAndAtAnySize() {
    for (const double scale : {1e-12, 1.0, 1e12}) {
      const Mesh mesh = test::placedAt(test::sphere(20, 40), scale, 1e6 * scale * Vec3(1, 2, 3));
      QVERIFY(greatestDeviation(mesh) < 0.05);
    }
  }

  void pointOnAVertexOrAtInfinityIsHarmless() {
    const Mesh mesh = test::sphere(20, 40);
    const Triangles triangles = triangulate(mesh.positions, mesh.faces);
    const WindingNumber winding(mesh.positions, triangles.vertices());
    QVERIFY(std::isfinite(winding.at(mesh.positions.row(17))));
    QVERIFY(!winding.isInside({1e30, 1e30, 0.0}));
    QVERIFY(!winding.isInside({1e200, 0.0, 0.0}));
  }

  void noTrianglesHaveNoInside() {
    const Points none(0, 3);
    const WindingNumber winding(none, {});
    QCOMPARE(winding.at({0, 0, 0}), 0.0);
    QVERIFY(!winding.triangles().isCrossed({-1, 0, 0}, {1, 0, 0}));
  }
};

const test::Registration<WindingNumberTest> registration;

}  // namespace pbffd

#include "winding_number_test.moc"
