#include "ui/views/gizmo.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::ui {

class GizmoTest : public QObject {
  Q_OBJECT

  static Projection aside() {
    Camera camera;
    camera.distance = 10.0;
    camera.turnTo(0.5, 0.4);
    return camera.projection(800, 600, {Vec3::Zero(), 2.0, 6.0});
  }
  static Gizmo of(GizmoKind kind) {
    Gizmo gizmo;
    gizmo.kind = kind;
    gizmo.center = Vec3(0.3, -0.2, 0.1);
    return gizmo;
  }
  static GizmoPart partAt(const GizmoShape& shape, const Projection& projection, const Vec3& world) {
    const Vec3 at = projection.toScreen(world);
    return shape.partAt(at.x(), at.y());
  }

 private Q_SLOTS:
  void partsAreFoundWhereTheyAre() {
    const Projection projection = aside();
    const Gizmo gizmo = of(GizmoKind::move);
    const GizmoShape shape(gizmo, projection);
    const GizmoPart axes[] = {GizmoPart::axisX, GizmoPart::axisY, GizmoPart::axisZ};
    const GizmoPart planes[] = {GizmoPart::planeX, GizmoPart::planeY, GizmoPart::planeZ};
    for (int axis = 0; axis < 3; ++axis) {
      QCOMPARE(partAt(shape, projection, 0.3 * gizmo.center + 0.7 * shape.axisEnd(axis)), axes[axis]);
      const auto corners = shape.planeCorners(axis);
      QCOMPARE(partAt(shape, projection, 0.5 * (corners[1] + corners[3])), planes[axis]);
    }
    QCOMPARE(partAt(shape, projection, gizmo.center), GizmoPart::center);
    QCOMPARE(shape.partAt(5, 5), GizmoPart::none);
  }

  void axisTowardsTheEyeCannotBeDragged() {
    Camera camera;
    camera.distance = 10.0;
    const Projection front = camera.projection(800, 600, {Vec3::Zero(), 2.0, 6.0});
    Gizmo gizmo;
    gizmo.kind = GizmoKind::move;
    const GizmoShape shape(gizmo, front);
    QVERIFY(!shape.isAxisSeen(2));
    QVERIFY(shape.isAxisSeen(0));
    QVERIFY(shape.isPlaneSeen(2));
    QVERIFY(!shape.isPlaneSeen(0));
  }

  void ringsAreFoundOnTheirNearSide() {
    const Projection projection = aside();
    const GizmoShape shape(of(GizmoKind::rotate), projection);
    const GizmoPart parts[] = {GizmoPart::axisX, GizmoPart::axisY, GizmoPart::axisZ};
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 nearest = shape.ring(axis).front();
      for (const Vec3& point : shape.ring(axis)) {
        if ((point - projection.lens().eye).norm() < (nearest - projection.lens().eye).norm()) {
          nearest = point;
        }
      }
      QCOMPARE(partAt(shape, projection, nearest), parts[axis]);
    }
    QCOMPARE(partAt(shape, projection, shape.ring(3).front()), GizmoPart::view);
    const Vec3 middle = projection.toScreen(of(GizmoKind::rotate).center);
    QCOMPARE(shape.partAt(middle.x() + 12, middle.y() + 9), GizmoPart::ball);
  }

  void sizeOnTheScreenDoesNotDependOnTheDistance() {
    for (const double distance : {2.0, 20.0, 2000.0}) {
      Camera camera;
      camera.distance = distance;
      const Projection projection = camera.projection(800, 600, {Vec3::Zero(), distance, distance});
      Gizmo gizmo;
      gizmo.kind = GizmoKind::move;
      const Vec3 end = projection.toScreen(GizmoShape(gizmo, projection).axisEnd(0));
      QVERIFY(std::abs(end.x() - 400.0 - GizmoSizes::length) < 1e-6);
    }
  }

  void hiddenGizmoHasNoParts() {
    const Projection projection = aside();
    QCOMPARE(GizmoShape(Gizmo{}, projection).partAt(400, 300), GizmoPart::none);
  }
};

const pbffd::test::Registration<GizmoTest> registration;

}  // namespace pbffd::ui

#include "gizmo_test.moc"
