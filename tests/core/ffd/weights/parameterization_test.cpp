#include "core/ffd/weights/parameterization.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class ParameterizationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void membersAndWeightsAreThoseOfTheFormula_data() {
    QTest::addColumn<int>("kernel");
    QTest::addColumn<bool>("paperMaster");
    QTest::newRow("smooth") << 0 << false;
    QTest::newRow("wendland") << 1 << false;
    QTest::newRow("gaussian") << 2 << false;
    QTest::newRow("gaussian, the paper's master") << 2 << true;
  }

  void membersAndWeightsAreThoseOfTheFormula() {
    QFETCH(int, kernel);
    QFETCH(bool, paperMaster);
    test::Scene scene(test::fork(0.1, 60, 21));
    scene.set.basis.kernel = static_cast<Kernel>(kernel);
    scene.set.master.mode = paperMaster ? MasterMode::paper : MasterMode::constant;
    const Eigen::MatrixXd expected = weightsByTheFormula(scene);
    const Eigen::MatrixXd stored = storedWeights(*scene.mesh, parameterized(scene));
    QVERIFY((stored - expected.leftCols(stored.cols())).cwiseAbs().maxCoeff() < 1e-7);
    QVERIFY(((stored.array() > 0.0) == (expected.leftCols(stored.cols()).array() > 0.0)).all());
    QVERIFY((expected.rowwise().sum().array() - 1.0).abs().maxCoeff() < 1e-14);
  }

  void weightsSumToOne() {
    test::Scene scene(test::sphere(40, 60));
    scene.set.master.value = 0.0;
    const Parameterization weights = parameterized(scene);
    const Eigen::VectorXd sums = storedWeights(*scene.mesh, weights).rowwise().sum();
    for (Index v = 0; v < sums.size(); ++v) {
      QVERIFY(sums[v] == 0.0 || std::abs(sums[v] - 1.0) < 1e-6);
    }
    QVERIFY(
        std::all_of(weights.masterMembers.begin(), weights.masterMembers.end(), [](auto m) { return m == 0; }));
  }

  void blocksListEachPointOnceAscending() {
    const test::Scene scene(test::sphere(41, 60));
    const Parameterization weights = parameterized(scene);
    QCOMPARE(weights.vertexCount, scene.mesh->vertexCount());
    QCOMPARE(weights.pointCount, scene.set.finest().size());
    QCOMPARE(weights.weights.size(), 16 * weights.points.size());
    for (Index b = 0; b < weights.blockCount(); ++b) {
      const BlockList list = weights.list(b);
      QVERIFY(std::adjacent_find(list.points.begin(), list.points.end(), std::greater_equal<>()) ==
              list.points.end());
      QVERIFY(std::find(list.members.begin(), list.members.end(), 0) == list.members.end());
      QVERIFY(std::find(list.points.begin(), list.points.end(), 5) == list.points.end());
    }
  }

  void bitsDoNotDependOnThreads() {
    const test::Scene scene(test::sphere(150, 151), 70);
    std::optional<ThreadLimit> limit(std::in_place, 1);
    const Parameterization alone = parameterized(scene);
    limit.emplace(7);
    const Parameterization many = parameterized(scene);
    QVERIFY(alone.blockStart == many.blockStart && alone.points == many.points &&
            alone.members == many.members);
    QVERIFY(alone.weights == many.weights && alone.masterMembers == many.masterMembers);
  }

  void noControlPointsLeaveTheMasterAlone() {
    test::Scene scene(test::cube(), 0);
    const Parameterization weights = parameterized(scene);
    QCOMPARE(weights.blockCount(), 1);
    QVERIFY(weights.points.empty());
    QVERIFY((weights.masterMembers[0] & 0xff) == 0xff);
  }

  void noVerticesMakeNoBlocks() {
    const RestMesh empty{Mesh()};
    test::Scene scene(test::cube(), 3);
    QCOMPARE(parameterize(empty, scene.set.basis, scene.set.master, scene.set.finest()).blockCount(), 0);
  }

  void cancelThrows() {
    const test::Scene scene(test::sphere());
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(
        parameterize(*scene.mesh, scene.set.basis, scene.set.master, scene.set.finest(), progress), Cancelled);
  }

 private:
  static Parameterization parameterized(const test::Scene& scene) {
    return parameterize(*scene.mesh, scene.set.basis, scene.set.master, scene.set.finest());
  }

  /// N x (M + 1), the master last: eqs. (3) and (5) by the letter, every vertex against every point.
  static Eigen::MatrixXd weightsByTheFormula(const test::Scene& scene) {
    const Level& level = scene.set.finest();
    Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(scene.mesh->vertexCount(), level.size() + 1);
    for (Index j = 0; j < level.size(); ++j) {
      if (level[j].enabled) {
        const Reached reached = reachedVertices(*scene.mesh, level[j]);
        for (std::size_t i = 0; i < reached.vertices.size(); ++i) {
          weights(reached.vertices[i], j) =
              level[j].strength * basisValue(scene.set.basis, reached.uSquared[i]);
        }
      }
    }
    const Region masterRegion(scene.set.master.rest);
    for (Index v = 0; v < scene.mesh->vertexCount(); ++v) {
      weights(v, level.size()) =
          scene.set.master.mode == MasterMode::constant
              ? scene.set.master.value
              : basisValue(scene.set.basis, masterRegion.squaredDistance(scene.mesh->positions().row(v)));
      weights.row(v) /= weights.row(v).sum();
    }
    return weights;
  }

  /// N x M, in file order.
  static Eigen::MatrixXd storedWeights(const RestMesh& mesh, const Parameterization& weights) {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(weights.vertexCount, weights.pointCount);
    for (Index b = 0; b < weights.blockCount(); ++b) {
      for (Index e = weights.blockStart[b]; e < weights.blockStart[b + 1]; ++e) {
        for (Index k = 0; k < std::min(16, weights.vertexCount - 16 * b); ++k) {
          dense(mesh.mortonOrder()[16 * b + k], weights.points[e]) = weights.weights[16 * e + k];
        }
      }
    }
    return dense;
  }
};

const test::Registration<ParameterizationTest> registration;

}  // namespace pbffd

#include "parameterization_test.moc"
