#include "core/ffd/deform/nearest_vertices.h"

#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <random>

namespace pbffd {

class NearestVerticesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyPlaceFindsTheNearestOfTheLowestIndex_data() {
    QTest::addColumn<Mesh>("shape");
    const Mesh fork = test::fork();
    QTest::newRow("one vertex") << firstVertices(fork, 1);
    QTest::newRow("less than a block") << firstVertices(fork, 15);
    QTest::newRow("a fork") << fork;
    QTest::newRow("every vertex twice") << test::merged(fork, fork);
    QTest::newRow("a stray part far away")
        << test::merged(fork, test::placedAt(test::sphere(), 0.01, {1e5, 2e5, -3e5}));
    QTest::newRow("a plane of many ties") << test::sheet(40);
    QTest::newRow("far from the origin") << test::placedAt(fork, 1.0, {1e6, -1e6, 1e6});
    QTest::newRow("more than one level of boxes") << test::sphere(120, 160);
  }
  void everyPlaceFindsTheNearestOfTheLowestIndex() {
    QFETCH(Mesh, shape);
    const RestMesh mesh(std::move(shape));
    const NearestVertices vertices(mesh);
    Index guess = 0;
    for (const Vec3& place : placesAbout(mesh)) {
      const Index expected = bruteForce(mesh.positions(), place);
      QCOMPARE(vertices.nearest(place, guess), expected);
      QCOMPARE(mesh.nearestVertex().nearest(place).index, expected);
      guess = (expected * 31 + guess) % mesh.vertexCount();
    }
  }

 private:
  static Mesh firstVertices(const Mesh& mesh, Eigen::Index count) {
    Mesh few;
    few.positions = mesh.positions.topRows(count);
    return few;
  }

  static Index bruteForce(const Points& positions, const Vec3& place) {
    Index best = 0;
    const auto squared = [&](Index v) {
      const Vec3 d = positions.row(v).transpose() - place;
      return d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
    };
    for (Index v = 1; v < positions.rows(); ++v) {
      best = squared(v) < squared(best) ? v : best;
    }
    return best;
  }

  /// At random, far away, on vertices, and halfway between two.
  static std::vector<Vec3> placesAbout(const RestMesh& mesh) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(-0.3, 1.3);
    const Vec3 low = mesh.bounds().low;
    const Vec3 size = mesh.bounds().high - low;
    const auto vertex = [&] { return Vec3(mesh.positions().row(random() % mesh.vertexCount())); };
    std::vector<Vec3> places;
    for (int i = 0; i < 300; ++i) {
      places.push_back(low + Vec3(share(random), share(random), share(random)).cwiseProduct(size));
      places.push_back(low + 1e4 * (places.back() - low));
      places.push_back(vertex());
      places.push_back(0.5 * (vertex() + vertex()));
      places.push_back(vertex() + 1e-3 * (places.front() - low));
    }
    return places;
  }
};

const test::Registration<NearestVerticesTest> registration;

}  // namespace pbffd

#include "nearest_vertices_test.moc"
