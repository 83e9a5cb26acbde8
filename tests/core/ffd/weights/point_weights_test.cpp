#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/ffd/weights/parameterization.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <Eigen/LU>
#include <QtTest>

#include <optional>

namespace pbffd {

class PointWeightsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void atVerticesTheyAreTheVerticesWeights() {
    const test::Scene scene(test::fork(0.1, 40, 17));
    const PointWeights rows = weighted(scene, scene.mesh->positions());
    const Parameterization stored =
        parameterize(*scene.mesh, scene.set.basis, scene.set.master, scene.set.finest());
    for (Index slot = 0; slot < scene.mesh->vertexCount(); ++slot) {
      const Index v = scene.mesh->mortonOrder()[slot];
      Index row = rows.start[v];
      const BlockList list = stored.list(slot / 16);
      for (std::size_t e = 0; e < list.points.size(); ++e) {
        if ((list.members[e] >> (slot % 16) & 1) != 0) {
          QVERIFY(row < rows.start[v + 1]);
          QCOMPARE(rows.points[row], list.points[e]);
          const std::size_t entry = static_cast<std::size_t>(stored.blockStart[slot / 16]) + e;
          QCOMPARE(static_cast<float>(rows.weights[row]), stored.weights[16 * entry + slot % 16]);
          ++row;
        }
      }
      QCOMPARE(row, rows.start[v + 1]);
    }
  }

  void weightsSumToOne() {
    test::Scene scene(test::sphere());
    const Points at = strewn(scene, 500);
    const PointWeights rows = weighted(scene, at);
    for (Index i = 0; i < at.rows(); ++i) {
      double sum = rows.master[i];
      for (Index e = rows.start[i]; e < rows.start[i + 1]; ++e) {
        sum += rows.weights[e];
      }
      QVERIFY(std::abs(sum - 1.0) < 1e-14);
    }
  }

  void aFreePointCountsAsItsNearestVertex() {
    const auto mesh = std::make_shared<RestMesh>(test::fork(0.1));
    Level level;
    level.append(test::pointAt(1, Vec3(2, 0.35, 0), 0.9));
    Points at(2, 3);
    at << 2, 0.02, 0, 2, -0.02, 0;
    const PointWeights rows = weightsAt(at, *mesh, {}, {}, level);
    QCOMPARE(rows.start[1] - rows.start[0], 1);
    QCOMPARE(rows.start[2] - rows.start[1], 0);
    const double value = basisValue({}, Region(level[0].rest).squaredDistance(at.row(0)));
    QVERIFY(std::abs(rows.weights[0] - value / (value + 0.01)) < 1e-15);
    QCOMPARE(rows.master[1], 1.0);
  }

  void aRegionWithoutVerticesRestrictsNothing() {
    const RestMesh mesh(test::cube());
    Level level;
    level.append(test::pointAt(1, Vec3(0, 0, 0), 0.3));
    Points at(1, 3);
    at << 0.1, 0, 0;
    QCOMPARE(weightsAt(at, mesh, {}, {}, level).start[1], 1);
    QCOMPARE(weightsAt(at, RestMesh{Mesh()}, {}, {}, level).start[1], 1);
  }

  void whatNothingReachesStays() {
    test::Scene scene(test::cube(), 3, 0.1);
    scene.set.master.value = 0.0;
    Points at(1, 3);
    at << 50, 0, 0;
    const PointWeights rows = weighted(scene, at);
    QCOMPARE(rows.start[1], 0);
    QCOMPARE(rows.master[0], 0.0);
    scene.poseBy(someMap());
    QVERIFY(blendedMap(rows, 0, mapsOf(scene.set, scene.set.finest())) == identityMap());
  }

  void blendOfMapsAtRestIsExactlyTheIdentity() {
    test::Scene scene(test::sphere());
    const PointWeights rows = weighted(scene, strewn(scene, 50));
    for (Index i = 0; i < 50; ++i) {
      QVERIFY(blendedMap(rows, i, mapsOf(scene.set, scene.set.finest())) == identityMap());
    }
  }

  void oneMapOfAllIsTheBlend() {
    test::Scene scene(test::sphere());
    const PointWeights rows = weighted(scene, strewn(scene, 50));
    scene.poseBy(someMap());
    for (Index i = 0; i < 50; ++i) {
      const AffineMap blend = blendedMap(rows, i, mapsOf(scene.set, scene.set.finest()));
      QVERIFY((blend - someMap()).cwiseAbs().maxCoeff() < 1e-13);
    }
  }

  void bitsDoNotDependOnThreads() {
    test::Scene scene(test::sphere(60, 61));
    const Points at = strewn(scene, 3000);
    std::optional<ThreadLimit> limit(std::in_place, 1);
    const PointWeights alone = weighted(scene, at);
    limit.emplace(7);
    const PointWeights many = weighted(scene, at);
    QVERIFY(alone.start == many.start && alone.points == many.points);
    QVERIFY(alone.weights == many.weights && alone.master == many.master);
  }

  void noPointsMakeNoRows() {
    const test::Scene scene(test::cube(), 3);
    const PointWeights rows = weighted(scene, Points(0, 3));
    QVERIFY(rows.start == std::vector<Index>{0});
    QVERIFY(rows.master.empty());
  }

  void cancelThrows() {
    test::Scene scene(test::sphere());
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(weightsAt(strewn(scene, 10), *scene.mesh, scene.set.basis, scene.set.master,
                                       scene.set.finest(), progress),
                             Cancelled);
  }

 private:
  static PointWeights weighted(const test::Scene& scene, const Points& at) {
    return weightsAt(at, *scene.mesh, scene.set.basis, scene.set.master, scene.set.finest());
  }

  static Points strewn(test::Scene& scene, Index count) {
    Points at(count, 3);
    for (Index i = 0; i < count; ++i) {
      at.row(i) = scene.vector(1.1);
    }
    return at;
  }

  static AffineMap someMap() {
    AffineMap map;
    map << 1, 0.2, 0, 3, -0.3, 0.9, 0.1, -2, 0, 0.4, 1.5, 0.7;
    return map;
  }
};

const test::Registration<PointWeightsTest> registration;

}  // namespace pbffd

#include "point_weights_test.moc"
