#include "core/ffd/placement/exterior_points.h"
#include "core/base/error.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>

namespace pbffd {
namespace {

SurfaceParts partsOf(Mesh mesh) {
  return {std::make_shared<const RestMesh>(std::move(mesh)), Surface::automatic};
}

}  // namespace

class ExteriorPointsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pointsStandOffTheSurfaceByTheOffset() {
    const SurfaceParts parts = partsOf(test::sphere());
    const ExteriorPools pools = exteriorPools(parts, everyVertex(parts), 0.2, {});
    QCOMPARE(pools.outside.size(), parts.mesh().vertexCount());
    QCOMPARE(pools.around.size(), 0);
    for (Index i = 0; i < pools.outside.size(); ++i) {
      QVERIFY(std::abs(pools.outside.points.row(i).norm() - 1.2) < 0.01);
    }
  }

  void thoseThatEndInsideAreRejected() {
    // The arms of the fork are nearer to each other than the offset.
    const SurfaceParts parts = partsOf(test::fork(0.2));
    const SurfaceSamples samples = everyVertex(parts);
    const ExteriorPools pools = exteriorPools(parts, samples, 0.35, {});
    QVERIFY(pools.outside.size() > 0);
    QVERIFY(pools.outside.size() < samples.size());
    for (Index i = 0; i < pools.outside.size(); ++i) {
      QVERIFY(!parts.isInside(pools.outside.points.row(i)));
    }
  }

  void thoseThatStartInsideAreRejectedToo() {
    // One mesh that runs through itself: between start and end is no wall, and yet both are inside.
    Mesh shape = test::merged(test::sphere(), test::placedAt(test::sphere(), 0.3, Vec3(0.1, 0, 0)));
    const Index joint[3] = {0, shape.vertexCount() / 2, 1};
    const Index back[3] = {1, shape.vertexCount() / 2, 0};
    shape.faces.add(joint);
    shape.faces.add(back);
    const SurfaceParts parts(std::make_shared<const RestMesh>(shape), Surface::closed);
    QCOMPARE(parts.count(), 1);
    const ExteriorPools pools = exteriorPools(parts, everyVertex(parts), 0.1, {});
    QVERIFY(pools.outside.size() > 0);
    for (Index i = 0; i < pools.outside.size(); ++i) {
      QVERIFY(!parts.isInside(pools.outside.points.row(i)));
    }
  }

  void openPartsGetBothSides() {
    const SurfaceParts parts = partsOf(test::sheet(6));
    const ExteriorPools pools = exteriorPools(parts, everyVertex(parts), 0.1, {});
    QCOMPARE(pools.outside.size(), 0);
    QCOMPARE(pools.around.size(), 2 * 49);
    QVERIFY(std::abs(pools.around.points.col(2).maxCoeff() - 0.1) < 1e-12);
    QVERIFY(std::abs(pools.around.points.col(2).minCoeff() + 0.1) < 1e-12);
  }

  void partWithinAnotherKeepsPoints() {
    const SurfaceParts closed =
        partsOf(test::merged(test::placedAt(test::sphere(), 5.0, Vec3::Zero()), test::sphere()));
    const ExteriorPools pools = exteriorPools(closed, everyVertex(closed), 0.2, {});
    QVERIFY(pools.enclosed.size() > 0);
    for (const Index part : pools.enclosed.parts) {
      QCOMPARE(part, 1);
    }
    const SurfaceParts open =
        partsOf(test::merged(test::placedAt(test::sphere(), 5.0, Vec3::Zero()), test::sheet(4)));
    QVERIFY(exteriorPools(open, everyVertex(open), 0.2, {}).around.size() > 0);
  }

  void cancelStopsIt() {
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    const SurfaceParts parts = partsOf(test::sphere());
    QVERIFY_EXCEPTION_THROWN(exteriorPools(parts, everyVertex(parts), 0.2, progress), Cancelled);
  }
};

const test::Registration<ExteriorPointsTest> registration;

}  // namespace pbffd

#include "exterior_points_test.moc"
