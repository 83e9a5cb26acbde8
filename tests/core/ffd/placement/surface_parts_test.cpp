#include "core/ffd/placement/surface_parts.h"
#include "core/base/error.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <random>

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

/// A grid of points in and around the mesh.
Points pointsAround(const RestMesh& mesh) {
  constexpr Index side = 24;
  const Vec3 size = mesh.bounds().high - mesh.bounds().low;
  Points points(side * side * side, 3);
  for (Index i = 0; i < points.rows(); ++i) {
    const Vec3 share = Vec3(i % side, i / side % side, i / side / side) / side;
    points.row(i) = mesh.bounds().low + (1.1 * share.array() - 0.05).matrix().cwiseProduct(size);
  }
  return points;
}

void requireLikelyFlagsOfTheWindingNumber(const SurfaceParts& parts) {
  const Points points = pointsAround(parts.mesh());
  const std::vector<bool> flags = parts.insideFlags(points, {});
  QVERIFY(std::count(flags.begin(), flags.end(), true) > 100);
  QVERIFY(parts.likelyInsideFlags(points, {}) == flags);
  // Voronoi vertices lie as far off as this.
  QVERIFY(parts.likelyInsideFlags(1e9 * points, {}) == parts.insideFlags(1e9 * points, {}));
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
    QVERIFY(parts.triangleNormal(0).dot(parts.mesh().positions().row(parts.mesh().triangles().vertices()[0])) >
            0.0);
  }

  void sidesOfANeedleAreTold() {
    // Inside and between are the same under affine maps.
    const Mesh fork = test::fork();
    const SurfaceParts plain = partsOf(fork);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> share(-0.1, 1.1);
    const Bounds& bounds = plain.bounds();
    for (const Vec3& factors : {Vec3(1e6, 1, 1), Vec3(1, 1, 1e-6), Vec3(1e5, 1, 1e-5)}) {
      Mesh needle = fork;
      needle.positions = fork.positions * factors.asDiagonal();
      const SurfaceParts parts = partsOf(turnedOver(needle));
      Vec3 before = Vec3::Zero();
      for (int i = 0; i < 1000; ++i) {
        const Vec3 at =
            bounds.low +
            Vec3(share(random), share(random), share(random)).cwiseProduct(bounds.high - bounds.low);
        QCOMPARE(parts.isInside(factors.cwiseProduct(at)), plain.isInside(at));
        QCOMPARE(parts.isBetween(factors.cwiseProduct(before), factors.cwiseProduct(at)),
                 plain.isBetween(before, at));
        before = at;
      }
    }
  }

  void verticesWithoutFacesHaveNoPlaceInTheBounds() {
    Mesh mesh = test::cube();
    mesh.positions.conservativeResize(9, 3);
    mesh.positions.row(8) << 1e6, 0, 0;
    const SurfaceParts parts = partsOf(mesh);
    QVERIFY((parts.bounds().high - Vec3::Constant(0.5)).norm() < 1e-12);
    QVERIFY(std::abs(parts.diagonal() - std::sqrt(3.0)) < 1e-12);
  }

  void facesThatDisagreeAreCountedUnlessAllIsTaken() {
    Mesh mesh;
    const Mesh cube = test::cube();
    mesh.positions = cube.positions;
    for (Index f = 0; f < 6; ++f) {
      std::vector<Index> face(cube.faces[f].begin(), cube.faces[f].end());
      if (f == 3) {
        std::reverse(face.begin(), face.end());
      }
      mesh.faces.add(face);
    }
    QCOMPARE(partsOf(mesh).inconsistentCount(), 1);
    QCOMPARE(partsOf(mesh).countOf(true), 0);
    QCOMPARE(partsOf(mesh, Surface::closed).inconsistentCount(), 0);
    QCOMPARE(partsOf(mesh, Surface::closed).countOf(true), 1);
  }

  void wallOfAHollowStaysAsItIs() {
    const SurfaceParts parts =
        partsOf(test::merged(test::cube(), turnedOver(test::placedAt(test::cube(), 0.5, Vec3::Zero()))));
    QVERIFY(!parts.isInside(Vec3::Zero()));
    QVERIFY(parts.isInside(Vec3(0.4, 0, 0)));
    QVERIFY(std::abs(parts.volume() - 0.875) < 1e-12);
  }

  void likelyFlagsAreThoseOfTheWindingNumber() {
    requireLikelyFlagsOfTheWindingNumber(partsOf(test::fork()));
    const Mesh ball = test::sphere(20, 40);
    requireLikelyFlagsOfTheWindingNumber(
        partsOf(test::merged(ball, test::placedAt(ball, 0.9, Vec3(0.05, 0, 0)))));
    // Open, and taken as closed: points come in without meeting a wall.
    Mesh bowl = ball;
    bowl.faces = {};
    for (Index f = 0; f < ball.faces.size() * 3 / 4; ++f) {
      bowl.faces.add(ball.faces[f]);
    }
    requireLikelyFlagsOfTheWindingNumber(partsOf(bowl, Surface::closed));
    // Closed, and a good part of it turned over: no wall stands where the winding number passes one half.
    Mesh patched = ball;
    patched.faces = {};
    for (Index f = 0; f < ball.faces.size(); ++f) {
      std::vector<Index> corners(ball.faces[f].begin(), ball.faces[f].end());
      if (f % 3 == 0) {
        std::reverse(corners.begin(), corners.end());
      }
      patched.faces.add(corners);
    }
    const SurfaceParts parts = partsOf(patched, Surface::closed);
    const Points points = pointsAround(parts.mesh());
    QVERIFY(parts.likelyInsideFlags(points, {}) == parts.insideFlags(points, {}));
  }

  void flagsCanBeCancelled() {
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    const SurfaceParts parts = partsOf(test::sphere());
    const Points points = pointsAround(parts.mesh());
    QVERIFY_EXCEPTION_THROWN(parts.insideFlags(points, progress), Cancelled);
    QVERIFY_EXCEPTION_THROWN(parts.likelyInsideFlags(points, progress), Cancelled);
  }
};

const test::Registration<SurfacePartsTest> registration;

}  // namespace pbffd

#include "surface_parts_test.moc"
