#include "core/mesh/triangle_tree.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <random>

namespace pbffd {

class TriangleTreeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void segmentThroughTheWallCrosses() {
    const Mesh mesh = test::cube();
    const Triangles triangles = triangulate(mesh.positions, mesh.faces);
    const TriangleTree tree(mesh.positions, triangles.vertices());
    QVERIFY(tree.isCrossed({0.1, 0.2, 0.3}, {0.1, 0.2, 0.7}));
    QVERIFY(tree.isCrossed({-3.0, 0.2, 0.3}, {3.0, 0.1, 0.2}));
    QVERIFY(!tree.isCrossed({0.1, 0.2, 0.3}, {-0.4, 0.2, -0.4}));
    QVERIFY(!tree.isCrossed({0.6, 0.2, 0.3}, {0.6, -4.0, 0.3}));
    QVERIFY(!tree.isCrossed({0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}));
  }

  void agreesWithTheSidesOfASphere() {
    const Mesh mesh = test::sphere(40, 80);
    const Triangles triangles = triangulate(mesh.positions, mesh.faces);
    const TriangleTree tree(mesh.positions, triangles.vertices());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(-1.5, 1.5);
    const auto at = [&] { return Vec3(share(random), share(random), share(random)); };
    int crossed = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vec3 from = at();
      const Vec3 to = at();
      // What lies within the rounding of the sphere to facets says nothing.
      if (std::abs(from.norm() - 1.0) < 0.01 || std::abs(to.norm() - 1.0) < 0.01) {
        continue;
      }
      const double along = std::clamp(-from.dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
      const double nearest = (from + along * (to - from)).norm();
      if (std::abs(nearest - 1.0) < 0.01) {
        continue;
      }
      const bool expected = std::max(from.norm(), to.norm()) > 1.0 && nearest < 1.0;
      QCOMPARE(tree.isCrossed(from, to), expected);
      crossed += expected;
    }
    QVERIFY(crossed > 300);
  }

  void holdsFarFromTheOriginAndAtAnySize() {
    for (const double scale : {1e-12, 1e12}) {
      const Vec3 shift = 1e6 * scale * Vec3(1, -2, 3);
      const Mesh mesh = test::placedAt(test::cube(), scale, shift);
      const Triangles triangles = triangulate(mesh.positions, mesh.faces);
      const TriangleTree tree(mesh.positions, triangles.vertices());
      QVERIFY(tree.isCrossed(shift, shift + scale * Vec3(0.7, 0.1, 0.2)));
      QVERIFY(!tree.isCrossed(shift, shift + scale * Vec3(0.4, 0.1, 0.2)));
    }
  }
};

const test::Registration<TriangleTreeTest> registration;

}  // namespace pbffd

#include "triangle_tree_test.moc"
