#include "core/ffd/weights/parameterization.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class ReachTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void connectedLeavesTheOtherArmAlone() {
    const RestMesh mesh(test::fork(0.1));
    const ControlPoint onUpperArm = test::pointAt(1, Vec3(2, 0.35, 0), 0.9);
    const Reached reached = reachedVertices(mesh, onUpperArm);
    QVERIFY(reached.vertices.size() > 20);
    for (const Index v : reached.vertices) {
      QVERIFY(mesh.positions()(v, 1) > 0.0);
    }
    ControlPoint all = onUpperArm;
    all.reach = Reach::all;
    QVERIFY(reachedVertices(mesh, all).vertices.size() > reached.vertices.size());
  }

  void aRegionAroundTheBendJoinsBothArms() {
    const RestMesh mesh(test::fork(0.1));
    ControlPoint wide = test::pointAt(1, Vec3(1, 0.35, 0), 3.0);
    const std::size_t connected = reachedVertices(mesh, wide).vertices.size();
    wide.reach = Reach::all;
    QCOMPARE(connected, reachedVertices(mesh, wide).vertices.size());
  }

  void verticesComeInOrderWithTheirDistances() {
    const test::Scene scene(test::sphere());
    const ControlPoint& point = scene.set.finest()[1];
    const Reached reached = reachedVertices(*scene.mesh, point);
    QVERIFY(std::is_sorted(reached.vertices.begin(), reached.vertices.end()));
    for (std::size_t i = 0; i < reached.vertices.size(); ++i) {
      const Vec3 vertex = scene.mesh->positions().row(reached.vertices[i]);
      QCOMPARE(reached.uSquared[i], Region(point.rest).squaredDistance(vertex));
      QVERIFY(reached.uSquared[i] < 1.0);
    }
  }

  void otherComponentsCountWhole() {
    // Two sheets, one above the other: the upper one counts although no edge joins it.
    const Mesh lower = test::sheet(10);
    const RestMesh mesh(test::merged(lower, test::placedAt(lower, 1.0, Vec3(0, 0, 0.2))));
    const Reached reached = reachedVertices(mesh, test::pointAt(1, Vec3(0, 0, -0.05), 0.5));
    const auto isUpper = [&](Index v) { return v >= lower.vertexCount(); };
    QVERIFY(std::any_of(reached.vertices.begin(), reached.vertices.end(), isUpper));
    QVERIFY(!std::all_of(reached.vertices.begin(), reached.vertices.end(), isUpper));
  }

  void ofOtherComponentsTheLimbsCountToo() {
    // The nearest vertex is a crumb of its own: the fork is another component, whole.
    Mesh crumb;
    crumb.positions.resize(1, 3);
    crumb.positions.row(0) = Vec3(2, 0, 0);
    const RestMesh mesh(test::merged(test::fork(0.1), crumb));
    const ControlPoint between = test::pointAt(1, Vec3(2, 0, 0), 0.9);
    ControlPoint all = between;
    all.reach = Reach::all;
    QVERIFY(reachedVertices(mesh, between).vertices == reachedVertices(mesh, all).vertices);
  }

  void verticesAtOnePositionAreOne() {
    // Two halves of a sheet that share their seam by position alone.
    const Mesh half = test::sheet(8);
    Mesh seam = test::merged(half, test::placedAt(half, 1.0, Vec3(2, 0, 0)));
    const RestMesh mesh(std::move(seam));
    const ControlPoint atSeam = test::pointAt(1, Vec3(0.9, 0.05, 0), 0.6);
    ControlPoint all = atSeam;
    all.reach = Reach::all;
    QVERIFY(reachedVertices(mesh, atSeam).vertices == reachedVertices(mesh, all).vertices);
    QCOMPARE(mesh.graph().componentCount(), 1);
  }

  void theLowestVertexWinsATie() {
    // Both arms are equally near: vertex numbers decide, whichever arm has the lower ones.
    Mesh arms = strips();
    const RestMesh mesh(arms);
    const std::vector<Index> lower{0, 1, 2};
    QVERIFY(reachedVertices(mesh, test::pointAt(1, Vec3(0, 0, 0), 1.2)).vertices == lower);
    arms.positions.col(1) *= -1.0;
    const RestMesh mirrored(arms);
    QVERIFY(reachedVertices(mirrored, test::pointAt(1, Vec3(0, 0, 0), 1.2)).vertices == lower);
  }

  void aRegionWithoutVerticesReachesNone() {
    const RestMesh mesh(test::cube());
    QVERIFY(reachedVertices(mesh, test::pointAt(1, Vec3(9, 9, 9), 1.0)).vertices.empty());
    QVERIFY(reachedVertices(mesh, test::pointAt(1, Vec3(0, 0, 0), 0.1)).vertices.empty());
  }

 private:
  /// Two strips of three vertices at y = +-1/2, joined far away at x = 9 only.
  static Mesh strips() {
    Mesh mesh;
    mesh.positions.resize(8, 3);
    mesh.positions << -0.5, 0.5, 0, 0, 0.5, 0, 0.5, 0.5, 0, -0.5, -0.5, 0, 0, -0.5, 0, 0.5, -0.5, 0, 9, 0.5, 0,
        9, -0.5, 0;
    for (const std::array<Index, 3>& face : {std::array<Index, 3>{0, 1, 2}, {3, 4, 5}, {2, 6, 7}, {5, 7, 6}}) {
      mesh.faces.add(face);
    }
    return mesh;
  }
};

const test::Registration<ReachTest> registration;

}  // namespace pbffd

#include "reach_test.moc"
