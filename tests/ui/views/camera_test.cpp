#include "ui/views/camera.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace pbffd::ui {

class CameraTest : public QObject {
  Q_OBJECT

  static Camera aside() {
    Camera camera;
    camera.focus = Vec3(1, 2, 3);
    camera.distance = 5.0;
    camera.turnTo(0.7, 0.3);
    return camera;
  }
  static Projection seen(const Camera& camera) { return camera.projection(800, 600, {camera.focus, 2.0, 6.0}); }

 private Q_SLOTS:
  void axesAreARotationWithoutRoll() {
    const Mat3 axes = aside().axes();
    QVERIFY((axes.transpose() * axes - Mat3::Identity()).norm() < 1e-14);
    QVERIFY(std::abs(axes.determinant() - 1.0) < 1e-14);
    QCOMPARE(axes(1, 0), 0.0);
    QVERIFY(axes(1, 1) > 0.0);
  }

  void raysPassThroughWhatTheyShow() {
    for (const bool orthographic : {false, true}) {
      Camera camera = aside();
      camera.orthographic = orthographic;
      const Projection projection = seen(camera);
      const Vec3 world(0.4, 2.9, 3.3);
      const Vec3 at = projection.toScreen(world);
      const PickRay ray = projection.rayThrough(at.x(), at.y());
      const Vec3 to = world - ray.origin;
      QVERIFY((to - to.dot(ray.direction) * ray.direction).norm() < 1e-12);
      QVERIFY(at.z() > 0.0 && at.z() < 1.0);
    }
  }

  void focusIsInTheMiddleAndAPixelIsAPixel() {
    const Camera camera = aside();
    const Projection projection = seen(camera);
    const Vec3 middle = projection.toScreen(camera.focus);
    QVERIFY(std::abs(middle.x() - 400.0) < 1e-9 && std::abs(middle.y() - 300.0) < 1e-9);
    const Vec3 beside = camera.focus + projection.pixelSizeAt(camera.focus) * camera.right();
    QVERIFY(std::abs(projection.toScreen(beside).x() - 401.0) < 1e-9);
  }

  void orbitLeavesThePivotOnItsPixel() {
    Camera camera = aside();
    const Vec3 pivot(1.5, 1.7, 2.6);
    const Vec3 before = seen(camera).toScreen(pivot);
    camera.orbit(pivot, 0.8, -0.4);
    const Vec3 after = seen(camera).toScreen(pivot);
    QVERIFY((before - after).head<2>().norm() < 1e-9);
  }

  void orbitStopsAtThePoles() {
    Camera camera = aside();
    camera.orbit(camera.focus, 0.0, 10.0);
    QCOMPARE(camera.pitch, std::numbers::pi / 2);
    QVERIFY(camera.axes().allFinite());
  }

  void zoomLeavesThePivotOnItsPixel() {
    for (const bool orthographic : {false, true}) {
      Camera camera = aside();
      camera.orthographic = orthographic;
      const Vec3 pivot(1.5, 1.7, 2.6);
      const Vec3 before = seen(camera).toScreen(pivot);
      const double pixel = seen(camera).pixelSizeAt(pivot);
      camera.zoom(pivot, 0.5);
      QVERIFY((before - seen(camera).toScreen(pivot)).head<2>().norm() < 1e-9);
      QVERIFY(std::abs(seen(camera).pixelSizeAt(pivot) - 0.5 * pixel) < 1e-12);
    }
  }

  void framedPointsFillTheView() {
    for (const bool orthographic : {false, true}) {
      Camera camera = aside();
      camera.orthographic = orthographic;
      double widest = 0.0;
      const auto corners = [](const std::function<void(const Vec3&)>& see) {
        for (int i = 0; i < 8; ++i) {
          see(Vec3(i & 1, 2 * ((i >> 1) & 1), 3 * ((i >> 2) & 1)));
        }
      };
      camera.frame(Vec3(0.5, 1, 1.5), corners, 800.0 / 600.0, 0.8);
      const Projection projection = seen(camera);
      corners([&](const Vec3& point) {
        const Vec3 at = projection.toScreen(point);
        widest = std::max({widest, std::abs(at.x() - 400) / 400, std::abs(at.y() - 300) / 300});
      });
      QVERIFY(std::abs(widest - 0.8) < 1e-9);
    }
  }

  void whatLiesBehindTheEyeIsNotSeen() {
    const Camera camera = aside();
    const Vec3 behind = camera.eye() - camera.forward();
    QVERIFY(seen(camera).isBehindEye(behind));
    QVERIFY(seen(camera).toScreen(behind).z() < -1.0);
  }
};

const pbffd::test::Registration<CameraTest> registration;

}  // namespace pbffd::ui

#include "camera_test.moc"
