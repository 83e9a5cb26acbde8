#include "ui/views/mesh_edges.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>
#include <set>

namespace pbffd::ui {

class MeshEdgesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void polygonsHaveTheirOwnEdgesOnly() {
    const RestMesh mesh(pbffd::test::cube());
    const MeshEdges edges = meshEdges(mesh);
    QCOMPARE(edges.slots.size(), std::size_t(2 * 12));
    for (std::size_t i = 0; i < edges.slots.size(); i += 2) {
      const Index a = mesh.mortonOrder()[edges.slots[i]];
      const Index b = mesh.mortonOrder()[edges.slots[i + 1]];
      QVERIFY(std::abs((mesh.positions().row(a) - mesh.positions().row(b)).norm() - 1.0) < 1e-12);
    }
    for (const float length : edges.meanLengths) {
      QCOMPARE(length, 1.0F);
    }
  }

  void sharedEdgesAreDrawnOnce() {
    const RestMesh mesh(pbffd::test::sheet(3));
    const MeshEdges edges = meshEdges(mesh);
    QCOMPARE(edges.slots.size(), std::size_t(2 * 24));
    std::set<std::pair<Index, Index>> distinct;
    for (std::size_t i = 0; i < edges.slots.size(); i += 2) {
      distinct.insert(std::minmax(edges.slots[i], edges.slots[i + 1]));
    }
    QCOMPARE(distinct.size(), std::size_t(24));
  }

  void verticesWithoutFacesHaveNoEdges() {
    Mesh mesh;
    mesh.positions = Points::Random(5, 3);
    const RestMesh cloud(std::move(mesh));
    const MeshEdges edges = meshEdges(cloud);
    QVERIFY(edges.slots.empty());
    QCOMPARE(edges.meanLengths, std::vector<float>(5, 0.0F));
  }
};

const pbffd::test::Registration<MeshEdgesTest> registration;

}  // namespace pbffd::ui

#include "mesh_edges_test.moc"
