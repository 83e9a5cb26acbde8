#include "core/mesh/rest_mesh.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <numeric>

namespace pbffd {

class RestMeshTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void mortonOrderHoldsEveryVertexOnce() {
    const RestMesh mesh(test::sphere());
    std::vector<Index> order = mesh.mortonOrder();
    std::sort(order.begin(), order.end());
    std::vector<Index> expected(order.size());
    std::iota(expected.begin(), expected.end(), 0);
    QCOMPARE(order, expected);
    QCOMPARE(order.size(), static_cast<std::size_t>(mesh.vertexCount()));
  }

  void blocksOfTheOrderAreCompact() {
    const RestMesh mesh(test::sphere(60, 120));
    const auto& order = mesh.mortonOrder();
    double sum = 0.0;
    int blocks = 0;
    for (std::size_t b = 0; b + 16 <= order.size(); b += 16) {
      Points block(16, 3);
      for (int i = 0; i < 16; ++i) {
        block.row(i) = mesh.positions().row(order[b + static_cast<std::size_t>(i)]);
      }
      sum += boundsOf(block).diagonal();
      ++blocks;
    }
    QVERIFY(sum / blocks < 0.15 * mesh.diagonal());
  }

  void pointsInOnePlaceHaveAnOrderToo() {
    Mesh mesh;
    mesh.positions = Points::Constant(5, 3, 7.0);
    QCOMPARE(RestMesh(mesh).mortonOrder(), (std::vector<Index>{0, 1, 2, 3, 4}));
  }

  void whatIsAskedForTwiceIsTheSameObject() {
    const RestMesh mesh(test::cube());
    QCOMPARE(&mesh.triangles(), &mesh.triangles());
    QCOMPARE(&mesh.graph(), &mesh.graph());
    QCOMPARE(mesh.bounds().diagonal(), std::sqrt(3.0));
  }
};

const test::Registration<RestMeshTest> registration;

}  // namespace pbffd

#include "rest_mesh_test.moc"
