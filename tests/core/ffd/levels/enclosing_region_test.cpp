#include "core/ffd/levels/enclosing_region.h"
#include "core/ffd/basis.h"
#include "core/ffd/frame_checks.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QtTest>

#include <cmath>
#include <random>

namespace pbffd {

class EnclosingRegionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sphereHasHalfTheDistanceAndTheLargerRadius() {
    const Frame first{Vec3(0, 0, 0), Mat3::Identity()};
    const Frame second{Vec3(4, 0, 0), Mat3(Vec3(1, 3, 2).asDiagonal())};
    const Frame region = enclosingRegion(first, second, RegionShape::sphere);
    QVERIFY(region.center == Vec3(2, 0, 0));
    QVERIFY(region.axes == Mat3(5.0 * Mat3::Identity()));
  }

  void bothShapesHoldBothRegions_data() {
    QTest::addColumn<int>("shape");
    QTest::newRow("sphere") << static_cast<int>(RegionShape::sphere);
    QTest::newRow("ellipsoid") << static_cast<int>(RegionShape::ellipsoid);
  }

  void bothShapesHoldBothRegions() {
    QFETCH(int, shape);
    std::mt19937 random(3);
    for (int trial = 0; trial < 30; ++trial) {
      const Frame first = randomFrame(random);
      const Frame second = randomFrame(random);
      const Frame region = enclosingRegion(first, second, static_cast<RegionShape>(shape));
      QVERIFY((region.center - 0.5 * (first.center + second.center)).norm() < 1e-12);
      QVERIFY(areOrthogonal(region.axes));
      QVERIFY(farthestOf(first, region) <= 1.0 + 1e-9);
      QVERIFY(farthestOf(second, region) <= 1.0 + 1e-9);
    }
  }

  void ellipsoidTouchesAndIsNoLargerThanTheSphere() {
    std::mt19937 random(4);
    for (int trial = 0; trial < 30; ++trial) {
      const Frame first = randomFrame(random);
      const Frame second = randomFrame(random);
      const Frame ellipsoid = enclosingRegion(first, second, RegionShape::ellipsoid);
      const Frame sphere = enclosingRegion(first, second, RegionShape::sphere);
      QVERIFY(volume(ellipsoid) <= volume(sphere) * (1.0 + 1e-6));
      QVERIFY(std::max(farthestOf(first, ellipsoid), farthestOf(second, ellipsoid)) > 0.99);
    }
  }

  // Two unit balls a distance 2 h apart: the least ellipsoid of revolution about their mid-point touches both
  // where a^2 and b^2 (a along the line) make the stationary volume; found here by trying all shapes.
  void ellipsoidOfTwoBallsIsTheLeast() {
    const double h = 1.5;
    const Frame first{Vec3(-h, 0, 0), Mat3::Identity()};
    const Frame second{Vec3(h, 0, 0), Mat3::Identity()};
    double least = 1e9;
    for (double ratio = 0.2; ratio < 1.0; ratio += 1e-4) {
      // Semi-axes a and ratio a; the least a that holds the ball about (h, 0, 0).
      double a = 0.0;
      for (double angle = 0.0; angle <= 3.1416; angle += 1e-2) {
        const double x = h + std::cos(angle);
        const double y = std::sin(angle) / ratio;
        a = std::max(a, std::sqrt(x * x + y * y));
      }
      least = std::min(least, a * a * a * ratio * ratio);
    }
    QVERIFY(std::abs(volume(enclosingRegion(first, second, RegionShape::ellipsoid)) / least - 1.0) < 1e-3);
  }

  void coincidentRegionsGiveThatRegion() {
    const Frame frame{Vec3(1, 2, 3), Mat3(Vec3(1, 2, 3).asDiagonal())};
    const Frame region = enclosingRegion(frame, frame, RegionShape::ellipsoid);
    QVERIFY(std::abs(volume(region) / volume(frame) - 1.0) < 1e-5);
    QVERIFY(farthestOf(frame, region) <= 1.0 + 1e-9);
  }

 private:
  static Frame randomFrame(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-2.0, 2.0);
    std::uniform_real_distribution<double> length(0.2, 1.5);
    const auto vector = [&] {
      const double x = place(random);
      const double y = place(random);
      return Vec3(x, y, place(random));
    };
    Frame frame;
    frame.center = vector();
    frame.axes = Eigen::AngleAxisd(place(random), vector().normalized()).toRotationMatrix();
    for (int k = 0; k < 3; ++k) {
      frame.axes.col(k) *= length(random);
    }
    return frame;
  }

  static double volume(const Frame& frame) { return std::abs(frame.axes.determinant()); }

  /// The largest |u| in `region` of points of the surface of `inner`.
  static double farthestOf(const Frame& inner, const Frame& region) {
    const Region outer(region);
    double farthest = 0.0;
    for (double polar = 0.0; polar <= 3.15; polar += 0.05) {
      for (double around = 0.0; around < 6.3; around += 0.05) {
        const Vec3 unit(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                        std::cos(polar));
        farthest = std::max(farthest, outer.squaredDistance(inner.center + inner.axes * unit));
      }
    }
    return std::sqrt(farthest);
  }
};

const test::Registration<EnclosingRegionTest> registration;

}  // namespace pbffd

#include "enclosing_region_test.moc"
