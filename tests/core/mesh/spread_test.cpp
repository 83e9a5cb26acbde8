#include "core/mesh/spread.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <random>

namespace pbffd {
namespace {

/// Points all over a box about the origin with these half sizes.
Points boxOfPoints(const Vec3& half, Index count = 3000) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  const Points unit = Points::NullaryExpr(count, 3, [&](Eigen::Index, Eigen::Index) { return share(random); });
  return unit * half.asDiagonal();
}

Points turned(const Points& points) {
  return points * Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).matrix();
}

}  // namespace

class SpreadTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void deviationsOfANeedleAreFoundWhicheverWayItLies() {
    const Vec3 half(1e6, 1.0, 1e-6);
    for (const Points& points : {boxOfPoints(half), turned(boxOfPoints(half))}) {
      const Spread spread = spreadAlongAxes(points);
      for (int k = 0; k < 3; ++k) {
        // Of numbers evenly spread over [-h, h].
        const double expected = half[2 - k] / std::sqrt(3.0);
        QVERIFY(std::abs(spread.deviations[k] / expected - 1.0) < 0.05);
      }
      QVERIFY((spread.axes.transpose() * spread.axes - Mat3::Identity()).norm() < 1e-12);
      QVERIFY(spread.axes.determinant() > 0.0);
    }
  }

  void centreAndDeviationsMoveAndGrowWithThePoints() {
    const Points points = boxOfPoints(Vec3(1, 2, 3));
    const Spread before = spreadAlongAxes(points);
    const Spread after = spreadAlongAxes((1e3 * points).array() + 1e5);
    QVERIFY((after.center - (1e3 * before.center + Vec3::Constant(1e5))).norm() < 1e-6);
    QVERIFY((after.deviations - 1e3 * before.deviations).norm() < 1e-6);
  }

  void sharesAreThoseOfTheLargest() {
    const Vec3 shares = spreadOf(boxOfPoints(Vec3(1, 10, 100)));
    QCOMPARE(shares[2], 1.0);
    QVERIFY(std::abs(shares[0] - 0.01) < 0.001);
    QVERIFY(spreadOf(Points::Constant(5, 3, 2.0)) == Vec3::Zero());
    QVERIFY(spreadOf(Points(0, 3)) == Vec3::Zero());
  }

  void flatSetsAreCoplanarAlsoFarFromTheOrigin() {
    const Points flat = turned(boxOfPoints(Vec3(1, 2, 0)));
    for (const double offset : {0.0, 1e6, 1e8}) {
      QVERIFY(areCoplanar(flat.array() + offset));
    }
    QVERIFY(!areCoplanar(turned(boxOfPoints(Vec3(1, 1, 1e-9)))));
  }
};

const test::Registration<SpreadTest> registration;

}  // namespace pbffd

#include "spread_test.moc"
