#include "core/ffd/placement/point_pool.h"
#include "core/base/error.h"
#include "core/ffd/placement/decimation.h"
#include "core/ffd/placement/exterior_points.h"
#include "tests/core/ffd/placement/placed.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <atomic>
#include <random>
#include <set>

namespace pbffd {
namespace {

SurfaceParts partsOf(Mesh mesh) {
  return {std::make_shared<const RestMesh>(std::move(mesh)), Surface::automatic};
}

/// A ball whose upper part is missing above a rim that goes up and down, taken as closed.
SurfaceParts openPot() {
  const Mesh ball = test::sphere(40, 80);
  Mesh pot;
  pot.positions = ball.positions;
  for (Index f = 0; f < ball.faces.size(); ++f) {
    Vec3 middle = Vec3::Zero();
    for (const Index vertex : ball.faces[f]) {
      middle += ball.positions.row(vertex).transpose() / static_cast<double>(ball.faces[f].size());
    }
    if (middle.z() < 0.6 * (middle.x() * middle.x() - middle.y() * middle.y())) {
      pot.faces.add(ball.faces[f]);
    }
  }
  return {std::make_shared<const RestMesh>(std::move(pot)), Surface::closed};
}

PointPool scattered(const SurfaceParts& parts, Index count, bool inside) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(-0.2, 1.2);
  const Bounds& bounds = parts.mesh().bounds();
  PointPool pool;
  while (pool.size() < count) {
    Vec3 at;
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = bounds.low[axis] + share(random) * (bounds.high[axis] - bounds.low[axis]);
    }
    if (parts.isInside(at) == inside) {
      pool.append(at, 0);
    }
  }
  pool.shrink();
  return pool;
}

/// An open sheet of n x n quads wholly inside a ball.
SurfaceParts sheetInBall(int n) {
  return partsOf(test::merged(test::placedAt(test::sphere(40, 80), 2.0, Vec3::Zero()), test::sheet(n)));
}

/// The places beside that sheet, none of which is outside.
PointPool besideSheet(const SurfaceParts& parts) {
  return exteriorPools(parts, everyVertex(parts), 0.05 * parts.diagonal(), {}).around;
}

}  // namespace

class PointPoolTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pointsStayOnTheirSide() {
    const SurfaceParts parts = partsOf(test::fork());
    for (const bool inside : {true, false}) {
      const PointPool pool = scattered(parts, 4000, inside);
      for (const Index target : {300, 20}) {
        const PointPool few = decimatedPool(pool, target, inside ? Side::inside : Side::outside, parts, {});
        QCOMPARE(few.size(), target);
        for (Index i = 0; i < target; ++i) {
          QCOMPARE(parts.isInside(few.points.row(i)), inside);
        }
      }
    }
  }

  void midPointsStayThereBesideAHole() {
    // Just above the mouth on either side, where it is low: no wall is between, and the mid-point is inside.
    const SurfaceParts parts = openPot();
    Vec3 at(0.0, 0.5, -0.5);
    while (parts.isInside(at)) {
      at.z() += 0.01;
    }
    const Vec3 opposite(0.0, -0.5, at.z());
    QVERIFY(!parts.isInside(opposite) && parts.isInside(0.5 * (at + opposite)) &&
            !parts.isBetween(at, opposite));
    PointPool pool;
    pool.append(at, 0);
    pool.append(opposite, 0);
    pool.shrink();
    const PointPool one = decimatedPool(pool, 1, Side::outside, parts, {});
    QCOMPARE(one.size(), 1);
    QVERIFY(!parts.isInside(one.points.row(0)));
  }

  void strayPointsAreTakenOutFirst() {
    const SurfaceParts parts = partsOf(test::cube());
    PointPool pool = scattered(parts, 200, true);
    pool.append(Vec3(5, 5, 5), 0);
    pool.shrink();
    const PointPool few = decimatedPool(pool, 50, Side::inside, parts, {});
    QCOMPARE(few.size(), 50);
    for (Index i = 0; i < few.size(); ++i) {
      QVERIFY(parts.isInside(few.points.row(i)));
    }
  }

  void upToThreeThousandPlacesMergeLikeTheClosestPairs() {
    // Nothing of the mesh lies between places within a convex one.
    const SurfaceParts parts = partsOf(test::cube());
    const PointPool pool = scattered(parts, 3000, true);
    for (const Index target : {1000, 100, 7}) {
      QVERIFY(decimatedPool(pool, target, Side::inside, parts, {}).points ==
              mergeClosestPairs(pool.points, target).points);
    }
  }

  void pairsWithoutAWallBetweenMergeFirst() {
    // Two above the sheet, and one below that is nearer to each of them than they are to each other.
    const SurfaceParts parts = sheetInBall(35);
    PointPool pool;
    pool.append(Vec3(0.00, 0.0, 0.05), 1);
    pool.append(Vec3(0.12, 0.0, 0.05), 1);
    pool.append(Vec3(0.06, 0.0, -0.04), 1);
    pool.shrink();
    QVERIFY(mergeClosestPairs(pool.points, 2).points != decimatedPool(pool, 2, Side::inside, parts, {}).points);
    const PointPool two = decimatedPool(pool, 2, Side::inside, parts, {});
    QCOMPARE(two.size(), 2);
    QCOMPARE((two.points.col(2).array() > 0.0).count(), 1);
    QVERIFY((two.points.rowwise() - Eigen::RowVector3d(0.06, 0.0, 0.05)).rowwise().norm().minCoeff() < 1e-12);
  }

  void openPartInsideAClosedOneMergesOnceAlongItsWalls() {
    const SurfaceParts parts = sheetInBall(35);
    const PointPool pool = besideSheet(parts);
    QCOMPARE(pool.size(), 2 * 36 * 36);
    std::atomic<Index> asked = 0;
    const MergeRules onceAlongWalls{pool.parts, [&](const Vec3& a, const Vec3& b) {
                                      ++asked;
                                      return parts.isBetween(a, b) ? 4.0 : 1.0;
                                    }};
    for (const Index target : {500, 100, 20, 2}) {
      asked = 0;
      const MergedPoints expected = mergeClosestPairs(pool.points, target, onceAlongWalls);
      QVERIFY(decimatedPool(pool, target, Side::outside, parts, {}).points == expected.points);
      QVERIFY(asked < 10 * pool.size());
    }
  }

  void openPartInsideAClosedOneIsSpreadEvenly() {
    const SurfaceParts parts = sheetInBall(90);
    const PointPool pool = besideSheet(parts);
    // One for each of 50 squares of 0.28 on either side.
    const PointPool few = decimatedPool(pool, 100, Side::outside, parts, {});
    QCOMPARE(few.size(), 100);
    QVERIFY(test::leastDistance(few.points) > 0.2);
  }

  void openPartInsideKeepsItsPointsWhereOthersStray() {
    const SurfaceParts parts = sheetInBall(35);
    PointPool pool = besideSheet(parts);
    const Index sheet = pool.parts[0];
    const PointPool outside = scattered(parts, 400, false);
    for (Index i = 0; i < outside.size(); ++i) {
      pool.append(outside.points.row(i), 1 - sheet);
    }
    pool.append(Vec3(0, 0, 1.5), 1 - sheet);
    pool.shrink();
    const PointPool few = decimatedPool(pool, 150, Side::outside, parts, {});
    QCOMPARE(few.size(), 150);
    PointPool ofSheet;
    for (Index i = 0; i < few.size(); ++i) {
      QCOMPARE(parts.isInside(few.points.row(i)), few.parts[i] == sheet);
      if (few.parts[i] == sheet) {
        ofSheet.append(few.points.row(i), sheet);
      }
    }
    ofSheet.shrink();
    QVERIFY(ofSheet.size() > 4);
    QVERIFY(test::leastDistance(ofSheet.points) > 0.2);
  }

  void doublesAreDroppedTheFirstStays() {
    PointPool pool;
    for (const double x : {2.0, 1.0, 2.0, 0.0, 1.0, 2.0}) {
      pool.append(Vec3(x, 0, 0), pool.size());
    }
    pool.dropDoubles();
    QCOMPARE(pool.parts, (std::vector<Index>{0, 1, 3}));
    QCOMPARE(pool.points.rows(), Eigen::Index(3));
    QCOMPARE(pool.points(2, 0), 0.0);
    PointPool none;
    none.dropDoubles();
    QCOMPARE(none.size(), 0);
  }

  void partsStayApartWhileThereAreEnoughPoints() {
    const SurfaceParts parts = partsOf(test::cube());
    PointPool pool = scattered(parts, 300, true);
    for (Index i = 0; i < pool.size(); ++i) {
      pool.parts[static_cast<std::size_t>(i)] = i % 5;
    }
    const PointPool few = decimatedPool(pool, 5, Side::inside, parts, {});
    QCOMPARE(std::set<Index>(few.parts.begin(), few.parts.end()).size(), std::size_t(5));
    QCOMPARE(decimatedPool(pool, 3, Side::inside, parts, {}).size(), 3);
    QCOMPARE(decimatedPool(pool, 0, Side::inside, parts, {}).size(), 0);
    QCOMPARE(decimatedPool(pool, 400, Side::inside, parts, {}).size(), 300);
  }

  void cancelStopsIt() {
    const SurfaceParts parts = partsOf(test::cube());
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(decimatedPool(scattered(parts, 300, true), 5, Side::inside, parts, progress),
                             Cancelled);
  }
};

const test::Registration<PointPoolTest> registration;

}  // namespace pbffd

#include "point_pool_test.moc"
