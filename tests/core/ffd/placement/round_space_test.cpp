#include "core/ffd/placement/round_space.h"

#include "core/mesh/spread.h"
#include "core/mesh/winding_number.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

namespace pbffd {
namespace {

Points stretched(const Points& points, const Vec3& factors) {
  return points * factors.asDiagonal();
}

}  // namespace

class RoundSpaceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void ordinaryShapesNeedNone() {
    for (const Mesh& mesh : {test::cube(), test::cylinder(), test::fork(), test::sphere()}) {
      QVERIFY(!RoundSpace::of(mesh.positions, mesh.positions).has_value());
    }
    QVERIFY(!RoundSpace::of(Points(0, 3), Points(0, 3)).has_value());
  }

  void needlesBecomeAsWideAsLong() {
    for (const Vec3& factors : {Vec3(1e6, 1, 1), Vec3(1, 1, 1e-6), Vec3(1e6, 1, 1e-6)}) {
      const Mat3 turn = Eigen::AngleAxisd(0.5, Vec3(3, 1, 2).normalized()).matrix();
      const Points needle = stretched(test::sphere().positions, factors) * turn;
      const auto space = RoundSpace::of(needle, needle);
      QVERIFY(space.has_value());
      const Vec3 shares = spreadOf(space->positions());
      QVERIFY(shares[0] > 0.005);
      QVERIFY(((*space)(needle.row(5)) - space->positions().row(5).transpose()).norm() < 1e-9);
    }
  }

  void whatIsInsideStaysInside() {
    const Mesh mesh = test::fork();
    const Triangles triangles = triangulate(mesh.positions, mesh.faces);
    const std::span<const Index> corners = triangles.vertices();
    // A reflection would turn the surface inside out.
    for (const Vec3& factors : {Vec3(1e6, 1, 1), Vec3(1, 1e6, 1), Vec3(1, 1, 1e6)}) {
      const Points needle = stretched(mesh.positions, factors);
      const auto space = RoundSpace::of(needle, needle);
      const Vec3 inside = Vec3(1.0, mesh.positions.col(1).minCoeff() + 0.3, 0.0);
      const double expected = exactWindingNumber(mesh.positions, corners, inside);
      const Vec3 there = (*space)(factors.cwiseProduct(inside));
      QVERIFY(std::abs(exactWindingNumber(space->positions(), corners, there) - expected) < 1e-6);
    }
  }

  void flatSetsStayFlat() {
    const Points flat = test::sheet().positions * Eigen::AngleAxisd(0.5, Vec3(3, 1, 2).normalized()).matrix();
    for (const double offset : {0.0, 1e8}) {
      const Points far = flat.array() + offset;
      const auto space = RoundSpace::of(far, far);
      QVERIFY(space.has_value());
      // What is left of its thickness is rounding and may not be taken for volume.
      QVERIFY(spreadOf(space->positions())[0] < 0.5);
    }
  }

  void onlyTheSurfaceCounts() {
    Points positions(9, 3);
    positions << test::cube().positions, Vec3(1e9, 0, 0).transpose();
    QVERIFY(!RoundSpace::of(positions, test::cube().positions).has_value());
  }

  void movingItLeavesThePositionsInPlace() {
    const Points needle = stretched(test::sphere().positions, Vec3(1e6, 1, 1));
    auto space = RoundSpace::of(needle, needle);
    const Points* const before = &space->positions();
    const RoundSpace moved = std::move(*space);
    QCOMPARE(&moved.positions(), before);
  }
};

const test::Registration<RoundSpaceTest> registration;

}  // namespace pbffd

#include "round_space_test.moc"
