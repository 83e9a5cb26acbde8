#include "core/mesh/topology.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <array>

namespace pbffd {
namespace {

Mesh withFaces(Index vertices, const std::vector<std::vector<Index>>& faces) {
  Mesh mesh;
  mesh.positions = Points::Random(vertices, 3);
  for (const auto& face : faces) {
    mesh.faces.add(face);
  }
  return mesh;
}

}  // namespace

class TopologyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cubeIsClosedAndOnePiece() {
    const Topology topology = topologyOf(test::cube());
    QVERIFY(topology.isClosed);
    QCOMPARE(topology.components, 1);
    QCOMPARE(topology.boundaryEdges, 0);
    QCOMPARE(topology.isolatedVertices, 0);
  }

  void sheetHasItsRimAsBoundary() {
    const Topology topology = topologyOf(test::sheet(10));
    QVERIFY(!topology.isClosed);
    QCOMPARE(topology.boundaryEdges, 40);
  }

  void componentsAreClosedOrOpenEachByItself() {
    const Topology topology = topologyOf(test::merged(test::sheet(4), test::cube()));
    QCOMPARE(topology.components, 2);
    QVERIFY(!topology.isComponentClosed[0]);
    QVERIFY(topology.isComponentClosed[1]);
    QCOMPARE(topology.componentOfFace.front(), 0);
    QCOMPARE(topology.componentOfFace.back(), 1);
  }

  void threeFacesOnAnEdgeAreCountedOnce() {
    const Topology topology = topologyOf(withFaces(5, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}));
    QCOMPARE(topology.nonmanifoldEdges, 1);
    QCOMPARE(topology.boundaryEdges, 6);
    QCOMPARE(topology.components, 1);
  }

  void fansThatMeetInAVertexKeepTheirEdges() {
    const Topology topology = topologyOf(withFaces(5, {{0, 1, 2}, {0, 3, 4}}));
    QCOMPARE(topology.nonmanifoldEdges, 0);
    QCOMPARE(topology.boundaryEdges, 6);
    QCOMPARE(topology.components, 1);
  }

  void aFaceTurnedOverOpensNothing() {
    Mesh mesh = test::cube();
    Polygons faces;
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      std::vector<Index> corners(mesh.faces[f].begin(), mesh.faces[f].end());
      if (f == 2) {
        std::reverse(corners.begin(), corners.end());
      }
      faces.add(corners);
    }
    mesh.faces = faces;
    const Topology topology = topologyOf(mesh);
    QVERIFY(topology.isClosed);
    QCOMPARE(topology.components, 1);
  }

  void isolatedVerticesAndDegenerateFacesAreNoTrouble() {
    const Topology topology = topologyOf(withFaces(6, {{0, 1, 2}, {3, 3, 3}, {0, 1, 1, 2}}));
    QCOMPARE(topology.isolatedVertices, 2);
    QVERIFY(!topology.isClosed || topology.boundaryEdges == 0);
  }

  void meshWithoutFacesIsNotClosed() {
    const Topology topology = topologyOf(withFaces(3, {}));
    QVERIFY(!topology.isClosed);
    QCOMPARE(topology.components, 0);
    QCOMPARE(topology.isolatedVertices, 3);
  }
};

const test::Registration<TopologyTest> registration;

}  // namespace pbffd

#include "topology_test.moc"
