#include "core/mesh/surface_graph.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class SurfaceGraphTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void neighboursAreThoseAlongEdgesOfFaces() {
    const SurfaceGraph graph(test::cube());
    const auto near = graph.neighbours(0);
    QCOMPARE(std::vector<Index>(near.begin(), near.end()), (std::vector<Index>{1, 2, 4}));
    QCOMPARE(graph.componentCount(), 1);
  }

  void verticesAtOnePlaceAreOne() {
    // Two triangles with vertices of their own that touch along an edge.
    Mesh mesh;
    mesh.positions.resize(6, 3);
    mesh.positions << 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0;
    mesh.faces.add(std::vector<Index>{0, 1, 2});
    mesh.faces.add(std::vector<Index>{3, 5, 4});
    const SurfaceGraph graph(mesh);
    QCOMPARE(graph.representative(3), 1);
    QCOMPARE(graph.representative(4), 2);
    QCOMPARE(graph.componentCount(), 1);
    QCOMPARE(graph.neighbours(1).size(), std::size_t(3));
  }

  void signOfZeroDoesNotPartVertices() {
    Mesh mesh;
    mesh.positions.resize(2, 3);
    mesh.positions << 0.0, 0, 0, -0.0, 0, 0;
    QCOMPARE(SurfaceGraph(mesh).representative(1), 0);
  }

  void isolatedVerticesAreComponents() {
    Mesh mesh = test::cube();
    mesh.positions.conservativeResize(9, 3);
    mesh.positions.row(8) = Vec3(5, 5, 5);
    const SurfaceGraph graph(mesh);
    QCOMPARE(graph.componentCount(), 2);
    QCOMPARE(graph.component(8), 1);
  }
};

const test::Registration<SurfaceGraphTest> registration;

}  // namespace pbffd

#include "surface_graph_test.moc"
