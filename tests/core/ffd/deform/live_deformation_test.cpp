#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/ffd/deform/deformation.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <bit>
#include <optional>

namespace pbffd {

class LiveDeformationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void agreesWithTheExactDeformation_data() {
    QTest::addColumn<int>("instructions");
    QTest::addColumn<bool>("withMaster");
    QTest::addColumn<bool>("paperMaster");
    for (const int instructions : {0, 1, 2}) {
      const QByteArray name = "instructions " + QByteArray::number(instructions);
      QTest::newRow(name + ", points alone") << instructions << false << false;
      QTest::newRow(name + ", master too") << instructions << true << false;
      QTest::newRow(name + ", the paper's master too") << instructions << true << true;
    }
  }

  void agreesWithTheExactDeformation() {
    QFETCH(int, instructions);
    QFETCH(bool, withMaster);
    QFETCH(bool, paperMaster);
    const auto wanted = static_cast<Instructions>(instructions);
    if (liveKernel(wanted) == nullptr) {
      QSKIP("this processor does not have the instructions");
    }
    test::Scene scene(test::fork(0.1, 50, 21));
    scene.set.master.mode = paperMaster ? MasterMode::paper : MasterMode::constant;
    const auto weights = weightsOf(scene);
    LiveDeformation live(scene.mesh, weights, wanted);
    scene.poseAtRandom(0.1, withMaster);
    live.update(mapsOf(scene.set, scene.set.finest()));
    QVERIFY(worstDifference(scene, live, *weights) < 1e-6 * scene.mesh->diagonal());
  }

  void translationsAgreeToo() {
    test::Scene scene(test::sphere(40, 41));
    const auto weights = weightsOf(scene);
    LiveDeformation live(scene.mesh, weights);
    for (Index j = 0; j < scene.set.finest().size(); ++j) {
      drag(scene, j, scene.vector(0.1));
    }
    live.update(mapsOf(scene.set, scene.set.finest()));
    QVERIFY(worstDifference(scene, live, *weights) < 1e-6 * scene.mesh->diagonal());
  }

  void farFromTheOriginNothingIsLost() {
    test::Scene scene(test::placedAt(test::sphere(), 1.0, Vec3(1e6, -2e6, 5e5)));
    const auto weights = weightsOf(scene);
    LiveDeformation live(scene.mesh, weights);
    scene.poseAtRandom(0.1, true);
    live.update(mapsOf(scene.set, scene.set.finest()));
    QVERIFY(worstDifference(scene, live, *weights) < 1e-6 * scene.mesh->diagonal());
  }

  void withoutAMasterWhatNothingReachesStays() {
    test::Scene scene(test::sphere(30, 40), 4, 0.1);
    scene.set.master.value = 0.0;
    const auto weights = weightsOf(scene);
    LiveDeformation live(scene.mesh, weights);
    scene.poseBy(makeMap(Mat3::Identity(), Vec3(5, 0, 0)));
    live.update(mapsOf(scene.set, scene.set.finest()));
    QVERIFY(worstDifference(scene, live, *weights) < 1e-6 * (scene.mesh->diagonal() + 5.0));
  }

  void restIsTheMeshInSinglePrecision() {
    const test::Scene scene(test::sphere());
    const LiveDeformation live(scene.mesh, weightsOf(scene));
    QCOMPARE(live.positions().size(), std::size_t(3 * scene.mesh->vertexCount()));
    for (Index slot = 0; slot < scene.mesh->vertexCount(); ++slot) {
      const Index v = scene.mesh->mortonOrder()[slot];
      for (int axis = 0; axis < 3; ++axis) {
        QCOMPARE(live.positions()[3 * slot + axis],
                 static_cast<float>(scene.mesh->positions()(v, axis) - live.origin()[axis]));
      }
    }
  }

  void tenThousandDragsAndTheirUndosLeaveNoTrace_data() {
    QTest::addColumn<int>("instructions");
    QTest::newRow("plain") << static_cast<int>(Instructions::plain);
    QTest::newRow("AVX2") << static_cast<int>(Instructions::avx2);
    QTest::newRow("AVX-512") << static_cast<int>(Instructions::avx512);
  }

  void tenThousandDragsAndTheirUndosLeaveNoTrace() {
    QFETCH(int, instructions);
    if (liveKernel(static_cast<Instructions>(instructions)) == nullptr) {
      QSKIP("this processor does not have the instructions");
    }
    test::Scene scene(test::sphere(20, 25), 30);
    LiveDeformation live(scene.mesh, weightsOf(scene), static_cast<Instructions>(instructions));
    const std::vector<float> restPositions = live.positions();
    const std::vector<float> restNormals = live.normals();
    scene.poseAtRandom(0.05, true);
    live.update(mapsOf(scene.set, scene.set.finest()));
    const std::vector<float> positions = live.positions();
    const std::vector<float> normals = live.normals();
    std::vector<ControlSet> before;
    for (int i = 0; i < 10000; ++i) {
      before.push_back(scene.set);
      dragByChance(scene);
      live.update(mapsOf(scene.set, scene.set.finest()));
    }
    QVERIFY(live.positions() != positions);
    for (; !before.empty(); before.pop_back()) {
      live.update(mapsOf(before.back(), before.back().finest()));
    }
    QVERIFY(live.positions() == positions && live.normals() == normals);
    scene.poseBy(identityMap());
    live.update(mapsOf(scene.set, scene.set.finest()));
    QVERIFY(live.positions() == restPositions && live.normals() == restNormals);
  }

  void theWayThereDoesNotMatter() {
    test::Scene scene(test::sphere(40, 41));
    const auto weights = weightsOf(scene);
    LiveDeformation byDrags(scene.mesh, weights);
    for (int i = 0; i < 40; ++i) {
      dragByChance(scene);
      byDrags.update(mapsOf(scene.set, scene.set.finest()));
    }
    LiveDeformation atOnce(scene.mesh, weights);
    atOnce.update(mapsOf(scene.set, scene.set.finest()));
    QVERIFY(atOnce.positions() == byDrags.positions() && atOnce.normals() == byDrags.normals());
  }

  void positionsAloneAndNormalsLaterComeToTheSame() {
    test::Scene scene(test::sphere(60, 61), 40, 0.1);
    const auto weights = weightsOf(scene);
    LiveDeformation inHalves(scene.mesh, weights);
    LiveDeformation whole(scene.mesh, weights);
    for (const Index point : {3, 17, 3, 30}) {
      drag(scene, point, scene.vector(0.1));
      inHalves.updatePositions(mapsOf(scene.set, scene.set.finest()));
      whole.update(mapsOf(scene.set, scene.set.finest()));
      QVERIFY(inHalves.positions() == whole.positions());
    }
    scene.set.master.pose.center.x() += 0.1;
    inHalves.updatePositions(mapsOf(scene.set, scene.set.finest()));
    drag(scene, 5, scene.vector(0.1));
    inHalves.updatePositions(mapsOf(scene.set, scene.set.finest()));
    whole.update(mapsOf(scene.set, scene.set.finest()));
    QVERIFY(inHalves.normals() != whole.normals());
    inHalves.updateNormals();
    QVERIFY(inHalves.positions() == whole.positions() && inHalves.normals() == whole.normals());
  }

  void aDragEvaluatesTheBlocksAroundIt() {
    test::Scene scene(test::sphere(60, 61), 40, 0.1);
    LiveDeformation live(scene.mesh, weightsOf(scene));
    QCOMPARE(live.update(mapsOf(scene.set, scene.set.finest())), 0);
    drag(scene, 0, Vec3(0.1, 0, 0));
    const Index evaluated = live.update(mapsOf(scene.set, scene.set.finest()));
    const auto reached =
        static_cast<Index>(reachedVertices(*scene.mesh, scene.set.finest()[0]).vertices.size());
    QVERIFY(evaluated >= reached && evaluated < scene.mesh->vertexCount() / 2);
    scene.set.master.pose.center.x() += 1.0;
    QCOMPARE(live.update(mapsOf(scene.set, scene.set.finest())), scene.mesh->vertexCount());
  }

  void bitsDoNotDependOnThreads() {
    test::Scene scene(test::sphere(120, 121));
    const auto weights = weightsOf(scene);
    scene.poseAtRandom(0.1, true);
    std::optional<ThreadLimit> limit(std::in_place, 1);
    LiveDeformation alone(scene.mesh, weights);
    alone.update(mapsOf(scene.set, scene.set.finest()));
    limit.emplace(7);
    LiveDeformation many(scene.mesh, weights);
    many.update(mapsOf(scene.set, scene.set.finest()));
    QVERIFY(alone.positions() == many.positions() && alone.normals() == many.normals());
  }

  void normalsAreThoseOfTheDeformedMesh_data() {
    QTest::addColumn<double>("scale");
    QTest::newRow("plain") << 1.0;
    QTest::newRow("tiny") << 1e-12;
    QTest::newRow("huge") << 1e12;
  }

  void normalsAreThoseOfTheDeformedMesh() {
    QFETCH(double, scale);
    test::Scene scene(test::placedAt(test::sphere(30, 33), scale, Vec3::Zero()));
    const auto weights = weightsOf(scene);
    LiveDeformation live(scene.mesh, weights);
    drag(scene, 0, scale * Vec3(0.1, 0.2, 0.0));
    drag(scene, 7, scale * Vec3(0.1, 0.2, 0.1));
    live.update(mapsOf(scene.set, scene.set.finest()));
    const Points expected =
        vertexNormals(deformExactly(*scene.mesh, scene.set, *weights), scene.mesh->triangles());
    for (Index slot = 0; slot < scene.mesh->vertexCount(); ++slot) {
      const Vec3 normal(live.normals()[3 * slot], live.normals()[3 * slot + 1], live.normals()[3 * slot + 2]);
      QVERIFY((normal - expected.row(scene.mesh->mortonOrder()[slot]).transpose()).norm() < 1e-4);
    }
  }

  void trianglesAreThoseOfTheMeshInSlots() {
    const test::Scene scene(test::cube(), 3);
    const LiveDeformation live(scene.mesh, weightsOf(scene));
    const std::span<const Index> vertices = scene.mesh->triangles().vertices();
    QCOMPARE(live.triangleSlots().size(), vertices.size());
    for (std::size_t c = 0; c < vertices.size(); ++c) {
      QCOMPARE(scene.mesh->mortonOrder()[live.triangleSlots()[c]], vertices[c]);
    }
  }

  void memoryBesideTheMeshIsBounded() {
    test::Scene scene(test::sphere(200, 250), 200, 0.14);
    const auto weights = weightsOf(scene);
    double influences = 0.0;
    for (const std::uint16_t members : weights->members) {
      influences += std::popcount(members);
    }
    influences /= scene.mesh->vertexCount();
    const double bytes = static_cast<double>(LiveDeformation(scene.mesh, weights).bytesOfWeights());
    QVERIFY(influences > 5.0);
    // 4 bytes an influence, and what lists and gaps between them take.
    QVERIFY(bytes / scene.mesh->vertexCount() < 96.0 / 16.0 * influences + 32.0);
  }

  void emptyMeshesAreDeformedToo() {
    const auto mesh = std::make_shared<const RestMesh>(Mesh());
    const auto weights = std::make_shared<const Parameterization>(parameterize(*mesh, {}, {}, Level()));
    LiveDeformation live(mesh, weights);
    QCOMPARE(live.update({}), 0);
    QVERIFY(live.positions().empty());
  }

  void unfittingWeightsAndMapsAreRefused() {
    const test::Scene scene(test::sphere());
    const test::Scene other(test::cube());
    QVERIFY_EXCEPTION_THROWN(LiveDeformation(scene.mesh, weightsOf(other)), InvalidInput);
    LiveDeformation live(scene.mesh, weightsOf(scene));
    QVERIFY_EXCEPTION_THROWN(live.update(LevelMaps()), InvalidInput);
  }

 private:
  static std::shared_ptr<const Parameterization> weightsOf(const test::Scene& scene) {
    return std::make_shared<const Parameterization>(
        parameterize(*scene.mesh, scene.set.basis, scene.set.master, scene.set.finest()));
  }

  static void drag(test::Scene& scene, Index place, const Vec3& by) {
    ControlPoint point = scene.set.finest()[place];
    point.pose.center += by;
    scene.set.levels[0].replace(place, point);
  }

  /// A few points moved or turned; now and then the master.
  static void dragByChance(test::Scene& scene) {
    for (unsigned n = 1 + scene.chance() % 3; n > 0; --n) {
      const auto place = static_cast<Index>(scene.chance() % static_cast<unsigned>(scene.set.finest().size()));
      if (scene.chance() % 2 == 0) {
        drag(scene, place, scene.vector(0.1));
      } else {
        ControlPoint point = scene.set.finest()[place];
        point.pose = scene.randomPose(point.rest, 0.05);
        scene.set.levels[0].replace(place, point);
      }
    }
    if (scene.chance() % 10 == 0) {
      scene.set.master.pose = scene.randomPose(scene.set.master.rest, 0.02);
    }
  }

  static double worstDifference(const test::Scene& scene, const LiveDeformation& live,
                                const Parameterization& weights) {
    const Points exact = deformExactly(*scene.mesh, scene.set, weights);
    double worst = 0.0;
    for (Index slot = 0; slot < scene.mesh->vertexCount(); ++slot) {
      const Vec3 position(live.positions()[3 * slot], live.positions()[3 * slot + 1],
                          live.positions()[3 * slot + 2]);
      const Vec3 expected = exact.row(scene.mesh->mortonOrder()[slot]).transpose() - live.origin();
      worst = std::max(worst, (position - expected).norm());
    }
    return worst;
  }
};

const test::Registration<LiveDeformationTest> registration;

}  // namespace pbffd

#include "live_deformation_test.moc"
