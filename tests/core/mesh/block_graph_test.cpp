#include "core/mesh/block_graph.h"
#include "core/mesh/rest_mesh.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <bit>
#include <set>

namespace pbffd {

class BlockGraphTest : public QObject {
  Q_OBJECT

  using Edges = std::set<std::pair<Index, Index>>;

  /// Both ways: along the edges of the surface graph, and between vertices at one position.
  static Edges edgesOf(const RestMesh& mesh) {
    Edges edges;
    for (Index v = 0; v < mesh.vertexCount(); ++v) {
      const Index first = mesh.graph().representative(v);
      if (first != v) {
        edges.insert({v, first});
        edges.insert({first, v});
      }
      for (const Index next : mesh.graph().neighbours(first)) {
        edges.insert({first, next});
      }
    }
    return edges;
  }

  static Edges edgesOf(const BlockGraph& graph, const std::vector<Index>& order) {
    Edges edges;
    const auto vertex = [&](Index block, int k) { return order[static_cast<std::size_t>(16 * block + k)]; };
    const auto add = [&](Index block, int k, Index other, unsigned slots) {
      for (; slots != 0; slots &= slots - 1) {
        edges.insert({vertex(block, k), vertex(other, std::countr_zero(slots))});
      }
    };
    for (Index block = 0; block < graph.blockCount(); ++block) {
      for (int k = 0; k < std::popcount(graph.all(block)); ++k) {
        add(block, k, block, graph.joined(16 * block + k));
        for (const BlockGraph::Link& link : graph.links(block)) {
          add(block, k, link.block, graph.joinedAcross(link, static_cast<std::uint16_t>(1U << k)));
        }
      }
    }
    return edges;
  }

 private Q_SLOTS:
  void holdsEveryEdgeOnce_data() {
    QTest::addColumn<Mesh>("mesh");
    QTest::newRow("sphere") << test::sphere(20, 31);
    QTest::newRow("fork") << test::fork(0.3);
    QTest::newRow("two halves with a seam")
        << test::merged(test::sheet(8), test::placedAt(test::sheet(8), 1.0, Vec3(2, 0, 0)));
    QTest::newRow("cube, less than a block") << test::cube();
  }

  void holdsEveryEdgeOnce() {
    QFETCH(Mesh, mesh);
    const RestMesh rest(std::move(mesh));
    QVERIFY(edgesOf(rest.blockGraph(), rest.mortonOrder()) == edgesOf(rest));
  }

  void linksJoinWhatTheirEdgesJoin() {
    const RestMesh rest(test::sphere(20, 31));
    const BlockGraph& graph = rest.blockGraph();
    for (Index block = 0; block < graph.blockCount(); ++block) {
      for (const BlockGraph::Link& link : graph.links(block)) {
        unsigned from = 0;
        unsigned to = 0;
        for (unsigned k = 0; k < 16; ++k) {
          const unsigned joined = graph.joinedAcross(link, static_cast<std::uint16_t>(1U << k));
          from |= static_cast<unsigned>(joined != 0) << k;
          to |= joined;
        }
        QCOMPARE(unsigned{link.from}, from);
        QCOMPARE(unsigned{link.to}, to);
        QVERIFY(link.block != block);
      }
    }
  }

  void aBlockOfTwoPiecesIsNotOne() {
    // Eight vertices of a cube and eight of another, far off: one block, two pieces.
    const RestMesh two(test::merged(test::cube(), test::placedAt(test::cube(), 1.0, Vec3(9, 0, 0))));
    QCOMPARE(two.blockGraph().blockCount(), 1);
    QVERIFY(!two.blockGraph().isOne(0));
    const RestMesh one(test::cube());
    QVERIFY(one.blockGraph().isOne(0));
    QCOMPARE(unsigned{one.blockGraph().all(0)}, 0xffU);
  }

  void verticesWithoutFacesHaveNoEdges() {
    Mesh cloud;
    cloud.positions = test::cube().positions;
    const RestMesh mesh(std::move(cloud));
    QVERIFY(mesh.blockGraph().links(0).empty());
    QCOMPARE(unsigned{mesh.blockGraph().joined(3)}, 0U);
    QCOMPARE(RestMesh(Mesh()).blockGraph().blockCount(), 0);
  }
};

const test::Registration<BlockGraphTest> registration;

}  // namespace pbffd

#include "block_graph_test.moc"
