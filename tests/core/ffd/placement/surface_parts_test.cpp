#include "core/ffd/placement/surface_parts.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>

namespace pbffd {
namespace {

SurfaceParts partsOf(Mesh mesh, Surface how = Surface::automatic) {
  return {std::make_shared<const RestMesh>(std::move(mesh)), how};
}

Mesh turnedOver(const Mesh& mesh) {
  Mesh turned;
  turned.positions = mesh.positions;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    turned.faces.add(std::vector<Index>(mesh.faces[f].rbegin(), mesh.faces[f].rend()));
  }
  return turned;
}

}  // namespace

class SurfacePartsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachPartIsClosedOrOpenUnlessToldOtherwise() {
    const Mesh mesh = test::merged(test::cube(), test::placedAt(test::sheet(4), 1.0, Vec3(5, 0, 0)));
    const SurfaceParts parts = partsOf(mesh);
    QCOMPARE(parts.count(), 2);
    QVERIFY(parts.isClosed(0));
    QVERIFY(!parts.isClosed(1));
    QCOMPARE(partsOf(mesh, Surface::closed).countOf(true), 2);
    QCOMPARE(partsOf(mesh, Surface::open).countOf(false), 2);
  }

  void areasAndVolumeAreThoseOfTheShapes() {
    const SurfaceParts parts =
        partsOf(test::merged(test::cube(), test::placedAt(test::sheet(4), 1.0, Vec3(5, 0, 0))));
    QVERIFY(std::abs(parts.areaOf(true) - 6.0) < 1e-12);
    QVERIFY(std::abs(parts.areaOf(false) - 4.0) < 1e-12);
    QVERIFY(std::abs(parts.volume() - 1.0) < 1e-12);
  }

  void openPartsHaveNoInside() {
    const SurfaceParts parts = partsOf(test::cube(), Surface::open);
    QVERIFY(!parts.isInside(Vec3::Zero()));
    QVERIFY(parts.isBetween(Vec3::Zero(), Vec3(2, 0.1, 0.2)));
    QCOMPARE(parts.volume(), 0.0);
  }

  void wallsOfAllPartsLieBetween() {
    const SurfaceParts parts =
        partsOf(test::merged(test::cube(), test::placedAt(test::sheet(4), 1.0, Vec3(0, 0, 3))));
    QVERIFY(parts.isBetween(Vec3::Zero(), Vec3(0.1, 0.1, 2)));
    QVERIFY(parts.isBetween(Vec3(0.1, 0.1, 2), Vec3(0.13, 0.1, 4)));
    QVERIFY(!parts.isBetween(Vec3(0.1, 0.1, 1), Vec3(0.1, 0.2, 2)));
  }

  void partInsideOutIsTurnedOver() {
    const SurfaceParts parts = partsOf(turnedOver(test::cube()));
    QVERIFY(parts.isInside(Vec3::Zero()));
    QVERIFY(std::abs(parts.volume() - 1.0) < 1e-12);
    for (Index v = 0; v < 8; ++v) {
      QVERIFY(parts.vertexNormal(v).dot(parts.mesh().positions().row(v)) > 0.0);
    }
    QVERIFY(parts.triangleNormal(0).dot(parts.mesh().positions().row(parts.mesh().triangles().vertices[0])) >
            0.0);
  }

  void wallOfAHollowStaysAsItIs() {
    const SurfaceParts parts =
        partsOf(test::merged(test::cube(), turnedOver(test::placedAt(test::cube(), 0.5, Vec3::Zero()))));
    QVERIFY(!parts.isInside(Vec3::Zero()));
    QVERIFY(parts.isInside(Vec3(0.4, 0, 0)));
    QVERIFY(std::abs(parts.volume() - 0.875) < 1e-12);
  }
};

const test::Registration<SurfacePartsTest> registration;

}  // namespace pbffd

#include "surface_parts_test.moc"
