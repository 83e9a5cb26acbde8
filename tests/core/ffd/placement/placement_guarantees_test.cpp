#include "core/ffd/placement/placement.h"
#include "core/ffd/placement/surface_parts.h"
#include "tests/core/ffd/placement/placed.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <Eigen/Core>
#include <cmath>

namespace pbffd {
namespace {

using test::Gaps;
using test::gapsOf;
using test::place;
using test::rest;
using test::stretched;
using test::withPoints;

/// All that the issue of placement promises for any closed mesh.
void requireGuarantees(const Mesh& mesh, const PlacementOptions& options) {
  const auto shared = rest(mesh);
  const PlacementResult result = placeControlPoints(shared, options);
  QCOMPARE(result.finest.size(), Index(options.points));
  QVERIFY(result.asClosed);
  const SurfaceParts parts(shared, Surface::automatic);
  PointId id = 1;
  for (const ControlPoint& point : result.finest) {
    QCOMPARE(point.id, id++);
    QCOMPARE(point.reach, options.reach);
    QVERIFY(point.rest == point.pose);
    QVERIFY(point.kind == PointKind::interior || point.kind == PointKind::exterior);
    QCOMPARE(parts.isInside(point.rest.center), point.kind == PointKind::interior);
    const Mat3 products = point.rest.axes.transpose() * point.rest.axes;
    for (int i = 0; i < 3; ++i) {
      QVERIFY(products(i, i) > 0.0);
      QVERIFY(std::abs(products(i, (i + 1) % 3)) <=
              1e-9 * std::sqrt(products(i, i) * products((i + 1) % 3, (i + 1) % 3)));
    }
  }
  const Gaps gaps = gapsOf(*shared, result.finest);
  QCOMPARE(gaps.uncovered, 0);
  QVERIFY(50 * gaps.idle <= options.points);
}

/// However many Voronoi vertices lie in one place.
void requireInteriorApart(const Mesh& mesh, const PlacementOptions& options) {
  const auto shared = rest(mesh);
  const PlacementResult result = placeControlPoints(shared, options);
  QCOMPARE(result.finest.size(), Index(options.points));
  Points inside(result.finest.size(), 3);
  Index count = 0;
  for (const ControlPoint& point : result.finest) {
    if (point.kind == PointKind::interior) {
      inside.row(count++) = point.rest.center;
    }
  }
  const double usual = std::cbrt(SurfaceParts(shared, Surface::automatic).volume() / count);
  const double least = test::leastDistance(inside.topRows(count));
  QVERIFY2(least > 0.4 * usual, qPrintable(QString("%1 of %2").arg(least).arg(usual)));
}

/// As a file of so many digits has it.
Mesh rounded(Mesh mesh, double unit) {
  mesh.positions = (mesh.positions / unit).array().round().matrix() * unit;
  return mesh;
}

}  // namespace

class PlacementGuaranteesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void closedShapesKeepAllPromises() {
    for (const int points : {100, 200, 1000}) {
      requireGuarantees(test::cube(), withPoints(points));
      requireGuarantees(test::sphere(), withPoints(points));
      requireGuarantees(test::cylinder(), withPoints(points));
      requireGuarantees(test::fork(), withPoints(points));
    }
  }

  void ellipsoidsAndPaperOptionsKeepThemToo() {
    PlacementOptions options = withPoints(200);
    options.regions = RegionShape::ellipsoid;
    requireGuarantees(test::fork(), options);
    requireGuarantees(test::cube(), options);
    PlacementOptions paper = paperOptions();
    requireGuarantees(test::fork(), paper);
    paper.reach = Reach::connected;
    requireGuarantees(test::fork(), paper);
  }

  void fineSpheresAreFilledEvenly() {
    const Mesh fine = test::sphere(100, 200);
    const Mesh two = test::merged(fine, test::placedAt(fine, 1.0, Vec3(3, 0, 0)));
    PlacementOptions everySite = withPoints(200);
    everySite.sites = 0;
    requireInteriorApart(fine, withPoints(200));
    requireInteriorApart(fine, withPoints(1000));
    requireInteriorApart(fine, everySite);
    requireInteriorApart(two, withPoints(200));
    // Their Voronoi vertices lie about the centre, more and more of them nearer and nearer.
    requireInteriorApart(rounded(test::placedAt(test::sphere(90, 180), 2.0, Vec3::Zero()), 1e-8),
                         withPoints(200));
    Mesh many;
    for (int i = 0; i < 8; ++i) {
      many = test::merged(many, test::placedAt(test::sphere(40, 80), 0.5 + 0.1 * i, Vec3(3.0 * i, 0, 0)));
    }
    requireInteriorApart(many, withPoints(200));
  }

  void solidsFarApartAreFilledEach() {
    // Their box is mostly empty: a grid over all of it finds none of them.
    Mesh balls;
    for (int i = 0; i < 6; ++i) {
      balls = test::merged(balls, test::placedAt(test::sphere(20, 40), 1.0, Vec3(200.0 * i, 90.0 * (i % 3), 0)));
    }
    requireInteriorApart(balls, withPoints(200));
  }

  void ballBesideThinPartsIsFilled() {
    // The sheet-like part alone has places enough for all points inside; the ball's medial surface is its centre.
    const Mesh ball = test::placedAt(test::sphere(40, 80), 1.0, Vec3(0, 0, 2));
    Mesh plate = test::sphere(60, 120);
    plate.positions = plate.positions * Vec3(3, 3, 0.02).asDiagonal();
    const auto shared = rest(test::merged(ball, plate));
    Index within = 0;
    for (const ControlPoint& point : placeControlPoints(shared, withPoints(200)).finest) {
      within += point.kind == PointKind::interior && (point.rest.center - Vec3(0, 0, 2)).norm() < 1.0;
    }
    QVERIFY(within > 4);
  }

  void farAndTinyMeshesKeepThePromises() {
    requireGuarantees(test::placedAt(test::fork(), 1.0, Vec3::Constant(1e8)), withPoints(100));
    requireGuarantees(test::placedAt(test::fork(), 1e-12, Vec3::Zero()), withPoints(100));
    requireGuarantees(test::placedAt(test::fork(), 1e12, Vec3::Zero()), withPoints(100));
  }

  void squashedSolidsGetAsManyAsAskedFor() {
    for (const Vec3& factors : {Vec3(1, 1, 1e-3), Vec3(1, 1e3, 1e-3), Vec3(1, 1e6, 1)}) {
      requireGuarantees(stretched(test::sphere(), factors), withPoints(100));
    }
  }

  void wildlyStretchedMeshesGetPointsInside() {
    const Mesh fork = test::fork();
    const SurfaceParts plain(rest(fork), Surface::automatic);
    for (const Vec3& factors : {Vec3(1e6, 1, 1), Vec3(1, 1, 1e-6)}) {
      requireGuarantees(stretched(fork, factors), withPoints(100));
      // Sides are the same in the mesh as it was.
      for (const ControlPoint& point : place(stretched(fork, factors), withPoints(100)).finest) {
        const Vec3 at = point.rest.center.cwiseQuotient(factors);
        QCOMPARE(plain.isInside(at), point.kind == PointKind::interior);
      }
    }
  }
};

const test::Registration<PlacementGuaranteesTest> registration;

}  // namespace pbffd

#include "placement_guarantees_test.moc"
