#include "ui/views/region_shape.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <Eigen/LU>
#include <cmath>

namespace pbffd::ui {

class RegionShapeTest : public QObject {
  Q_OBJECT

  static Frame skewed() {
    Frame frame;
    frame.center = Vec3(0.5, -1, 2);
    frame.axes << 1.0, 0.3, 0.0, 0.1, 0.7, -0.2, 0.0, 0.2, 1.5;
    return frame;
  }

 private Q_SLOTS:
  void ringsLieOnTheRegion() {
    const Frame frame = skewed();
    for (const auto& ring : regionRings(frame, 24)) {
      QCOMPARE(ring.size(), std::size_t(24));
      for (const Vec3& point : ring) {
        QVERIFY(std::abs((frame.axes.inverse() * (point - frame.center)).norm() - 1.0) < 1e-12);
      }
    }
  }

  void outlineIsWhereRaysTouch() {
    for (const bool orthographic : {false, true}) {
      const Frame frame = skewed();
      Camera camera;
      camera.distance = 8.0;
      camera.orthographic = orthographic;
      camera.turnTo(1.0, 0.5);
      const Projection projection = camera.projection(800, 600, {Vec3::Zero(), 4.0, 8.0});
      const auto outline = regionOutline(frame, projection.lens(), 32);
      QCOMPARE(outline.size(), std::size_t(32));
      for (const Vec3& point : outline) {
        const Vec3 local = frame.axes.inverse() * (point - frame.center);
        QVERIFY(std::abs(local.norm() - 1.0) < 1e-9);
        const Vec3 seen = projection.toScreen(point);
        const PickRay ray = projection.rayThrough(seen.x(), seen.y());
        const Vec3 direction = (frame.axes.inverse() * ray.direction).normalized();
        QVERIFY(std::abs(direction.dot(local)) < 1e-9);
      }
    }
  }

  void thereIsNoOutlineFromWithinNorOfASingularFrame() {
    Camera camera;
    camera.distance = 0.5;
    const Projection projection = camera.projection(800, 600, {Vec3::Zero(), 1.0, 1.0});
    QVERIFY(regionOutline(Frame{}, projection.lens(), 16).empty());
    Frame flat;
    flat.axes.col(1).setZero();
    QVERIFY(regionOutline(flat, projection.lens(), 16).empty());
  }
};

const pbffd::test::Registration<RegionShapeTest> registration;

}  // namespace pbffd::ui

#include "region_shape_test.moc"
