#include "core/ffd/placement/region_shape.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <Eigen/LU>
#include <cmath>
#include <vector>

namespace pbffd {
namespace {

Points rowsOf(const std::vector<Vec3>& all) {
  Points points(static_cast<Index>(all.size()), 3);
  for (std::size_t i = 0; i < all.size(); ++i) {
    points.row(static_cast<Index>(i)) = all[i];
  }
  return points;
}

double ratio(const Frame& frame) {
  const auto lengths = frame.axes.colwise().norm();
  return lengths.maxCoeff() / lengths.minCoeff();
}

}  // namespace

class RegionShapeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pointsInTheSamePlaceLookForTheNearestApart() {
    Points points = Points::Zero(40, 3);
    points(39, 0) = 2.0;
    for (const Frame& region : regionsOf(points, 1.5, RegionShape::sphere, 9.0)) {
      QVERIFY(region.axes == 3.0 * Mat3::Identity());
    }
    QVERIFY(regionsOf(Points::Zero(40, 3), 1.5, RegionShape::sphere, 9.0)[7].axes == 13.5 * Mat3::Identity());
  }

  void ballsReachTheNearestPointTimesTheFactor() {
    const Points points = rowsOf({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}});
    const std::vector<Frame> regions = regionsOf(points, 1.5, RegionShape::sphere, 9.0);
    QVERIFY(regions[0].axes == 1.5 * Mat3::Identity());
    QVERIFY(regions[1].axes == 1.5 * Mat3::Identity());
    QVERIFY(regions[2].axes == 3.0 * Mat3::Identity());
    QVERIFY(regions[2].center == Vec3(3, 0, 0));
  }

  void pointWithoutNeighbourTakesTheLoneDistance() {
    QVERIFY(regionsOf(rowsOf({{1, 2, 3}}), 2.0, RegionShape::sphere, 9.0)[0].axes == 18.0 * Mat3::Identity());
    const auto twins = regionsOf(rowsOf({{1, 2, 3}, {1, 2, 3}}), 2.0, RegionShape::ellipsoid, 9.0);
    QVERIFY(twins[0].axes == 18.0 * Mat3::Identity());
  }

  void ellipsoidsAreLongAlongALine() {
    std::vector<Vec3> line;
    for (int i = 0; i < 20; ++i) {
      line.emplace_back(Vec3(1, 2, 2) / 3.0 * i);
    }
    const Frame middle = regionsOf(rowsOf(line), 2.0, RegionShape::ellipsoid, 1.0)[10];
    QVERIFY(std::abs(ratio(middle) - 2.5) < 1e-9);
    int longest = 0;
    middle.axes.colwise().norm().maxCoeff(&longest);
    QVERIFY(std::abs(std::abs(middle.axes.col(longest).normalized().dot(Vec3(1, 2, 2) / 3.0)) - 1.0) < 1e-9);
  }

  void ellipsoidsAreFlatInAPlane() {
    std::vector<Vec3> plane;
    for (int i = 0; i < 81; ++i) {
      plane.emplace_back(i % 9, i / 9, 0.0);
    }
    const Frame middle = regionsOf(rowsOf(plane), 2.0, RegionShape::ellipsoid, 1.0)[40];
    int shortest = 0;
    middle.axes.colwise().norm().minCoeff(&shortest);
    QVERIFY(std::abs(std::abs(middle.axes.col(shortest).normalized().z()) - 1.0) < 1e-9);
  }

  void ellipsoidsHaveTheVolumeOfTheBallAndOrthogonalRightHandedAxes() {
    Points points(60, 3);
    for (Index i = 0; i < 60; ++i) {
      points.row(i) = Vec3(std::sin(1.7 * i), 2.0 * std::cos(2.3 * i), 0.3 * std::sin(3.1 * i));
    }
    const auto balls = regionsOf(points, 2.0, RegionShape::sphere, 1.0);
    const auto ellipsoids = regionsOf(points, 2.0, RegionShape::ellipsoid, 1.0);
    for (std::size_t i = 0; i < 60; ++i) {
      const Mat3& axes = ellipsoids[i].axes;
      QVERIFY(std::abs(axes.determinant() / balls[i].axes.determinant() - 1.0) < 1e-9);
      QVERIFY(ratio(ellipsoids[i]) < 2.5 + 1e-9);
      for (int k = 0; k < 3; ++k) {
        const Vec3 a = axes.col(k).normalized();
        const Vec3 b = axes.col((k + 1) % 3).normalized();
        QVERIFY(std::abs(a.dot(b)) < 1e-12);
      }
    }
  }
};

const test::Registration<RegionShapeTest> registration;

}  // namespace pbffd

#include "region_shape_test.moc"
