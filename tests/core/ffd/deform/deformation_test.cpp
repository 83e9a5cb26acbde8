#include "core/ffd/deform/deformation.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/ffd/deform/strain.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QtTest>

#include <cstring>
#include <optional>

namespace pbffd {

class DeformationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void restIsTheVeryMesh() {
    const test::Scene scene(test::fork());
    const Points deformed = deform(scene);
    QCOMPARE(std::memcmp(deformed.data(), scene.mesh->positions().data(), sizeof(double) * deformed.size()), 0);
  }

  void whatNothingMovedReachesKeepsItsBits() {
    test::Scene scene(test::placedAt(test::sphere(30, 40), 1.0, Vec3(0, -0.0, 0)), 30, 0.15);
    ControlPoint point = scene.set.finest()[0];
    point.pose.center += Vec3(0.1, 0.2, 0.3);
    scene.set.levels[0].replace(0, point);
    const Points deformed = deform(scene);
    const std::vector<Index> reached = reachedVertices(*scene.mesh, point).vertices;
    QVERIFY(!reached.empty());
    for (Index v = 0; v < scene.mesh->vertexCount(); ++v) {
      const bool isSame =
          std::memcmp(deformed.row(v).data(), scene.mesh->positions().row(v).data(), 3 * sizeof(double)) == 0;
      QCOMPARE(isSame, !std::binary_search(reached.begin(), reached.end(), v));
    }
  }

  void displacementFormIsEquationSeven_data() {
    QTest::addColumn<bool>("paperMaster");
    QTest::addColumn<int>("kernel");
    QTest::newRow("constant master, smooth") << false << 0;
    QTest::newRow("the paper's master, gaussian") << true << 2;
    QTest::newRow("the paper's master, wendland") << true << 1;
  }

  void displacementFormIsEquationSeven() {
    QFETCH(bool, paperMaster);
    QFETCH(int, kernel);
    test::Scene scene(test::fork(0.1, 40, 20));
    scene.set.master.mode = paperMaster ? MasterMode::paper : MasterMode::constant;
    scene.set.basis.kernel = static_cast<Kernel>(kernel);
    scene.poseAtRandom(0.1, true);
    const double worst = (deform(scene) - equationSeven(scene)).rowwise().norm().maxCoeff();
    QVERIFY(worst < 1e-12 * scene.mesh->diagonal());
  }

  void oneMapOfAllCarriesTheMesh_data() {
    QTest::addColumn<double>("shift");
    QTest::newRow("at the origin") << 0.0;
    QTest::newRow("far away") << 100.0;
  }

  void oneMapOfAllCarriesTheMesh() {
    QFETCH(double, shift);
    test::Scene scene(test::placedAt(test::sphere(), 1.0, Vec3::Constant(shift)));
    AffineMap map;
    map << 0.8, -0.6, 0.2, 1, 0.6, 0.8, 0, 2, 0.1, 0, 1.4, -3;
    scene.poseBy(map);
    const Points deformed = deform(scene);
    for (Index v = 0; v < deformed.rows(); ++v) {
      const Vec3 expected = applyMap(map, scene.mesh->positions().row(v));
      QVERIFY((deformed.row(v).transpose() - expected).norm() < 1e-12 * (scene.mesh->diagonal() + shift));
    }
  }

  void withoutAMasterWhatNothingReachesStays() {
    test::Scene scene(test::sphere(30, 40), 4, 0.1);
    scene.set.master.value = 0.0;
    scene.poseBy(makeMap(Mat3::Identity(), Vec3(5, 0, 0)));
    const Points deformed = deform(scene);
    Index stayed = 0;
    for (Index v = 0; v < deformed.rows(); ++v) {
      const double moved = deformed(v, 0) - scene.mesh->positions()(v, 0);
      QVERIFY(moved == 0.0 || std::abs(moved - 5.0) < 1e-13);
      stayed += moved == 0.0;
    }
    QVERIFY(stayed > 0 && stayed < deformed.rows());
  }

  void bitsDoNotDependOnThreads() {
    test::Scene scene(test::sphere(120, 121));
    scene.poseAtRandom(0.1, true);
    std::optional<ThreadLimit> limit(std::in_place, 1);
    const Points alone = deform(scene);
    const std::vector<Mat3> gradientsAlone = gradients(scene);
    limit.emplace(7);
    QVERIFY(deform(scene) == alone);
    QVERIFY(gradients(scene) == gradientsAlone);
  }

  void disabledPointsMoveNothing() {
    test::Scene scene(test::sphere());
    ControlPoint disabled = scene.set.finest()[5];
    QVERIFY(!disabled.enabled);
    disabled.pose.center.x() += 1.0;
    scene.set.levels[0].replace(5, disabled);
    QVERIFY(deform(scene) == scene.mesh->positions());
  }

  void gradientsAreTheDifferencesOfTheDeformation_data() { displacementFormIsEquationSeven_data(); }

  void gradientsAreTheDifferencesOfTheDeformation() {
    QFETCH(bool, paperMaster);
    QFETCH(int, kernel);
    test::Scene scene(test::sphere(24, 30));
    scene.set.master.mode = paperMaster ? MasterMode::paper : MasterMode::constant;
    scene.set.basis.kernel = static_cast<Kernel>(kernel);
    reachAll(scene.set);
    scene.poseAtRandom(0.05, true);
    const std::vector<Mat3> exact = gradients(scene);
    const std::vector<Mat3> numeric = differences(scene);
    for (int axis = 0; axis < 3; ++axis) {
      Index wrong = 0;
      for (std::size_t v = 0; v < numeric.size(); ++v) {
        wrong += (numeric[v].col(axis) - exact[v].col(axis)).norm() > 1e-6;
      }
      // The gaussian jumps at the border of a region: a vertex that h takes across it has no gradient.
      QVERIFY(kernel == 2 ? wrong < 3 : wrong == 0);
    }
  }

  void normalsFramesAndStrainAreTheDifferencesToo() {
    test::Scene scene(test::sphere(24, 30));
    reachAll(scene.set);
    scene.poseAtRandom(0.05, true);
    const std::vector<Mat3> exact = gradients(scene);
    const std::vector<Mat3> numeric = differences(scene);
    for (Index v = 0; v < scene.mesh->vertexCount(); ++v) {
      const Mat3& seen = numeric[v];
      const Vec3 normal = scene.mesh->normals().row(v);
      const Vec3 tangent = normal.unitOrthogonal();
      const Vec3 across = normal.cross(tangent);
      const Vec3 turned = (seen * tangent).cross(seen * across).normalized();
      QVERIFY((carriedTangent(exact[v], tangent) - seen * tangent).norm() < 1e-6);
      QVERIFY((carriedNormal(exact[v], normal) - turned).norm() < 1e-5);
      const Strain strain = strainOf(exact[v]);
      QVERIFY(std::abs(strain.volume - seen.determinant()) < 1e-5);
      QVERIFY(std::abs(strain.stretches.squaredNorm() - seen.squaredNorm()) < 1e-5);
      // Higham's iteration finds the rotation of a polar decomposition without a singular value.
      Mat3 rotation = seen;
      for (int i = 0; i < 30; ++i) {
        rotation = (0.5 * (rotation + rotation.inverse().transpose())).eval();
      }
      if (seen.determinant() > 0.1) {
        QVERIFY((carriedRotation(exact[v]) - rotation).norm() < 1e-4);
      }
    }
  }

  void gradientsAtRestAreIdentities() {
    const test::Scene scene(test::sphere());
    for (const Mat3& gradient : gradients(scene)) {
      QVERIFY(gradient == Mat3::Identity());
    }
  }

  void gradientsOfOneMapAreItsLinearPart() {
    test::Scene scene(test::fork());
    AffineMap map;
    map << 0.8, -0.6, 0.2, 1, 0.6, 0.8, 0, 2, 0.1, 0, 1.4, -3;
    scene.poseBy(map);
    for (const Mat3& gradient : gradients(scene)) {
      QVERIFY((gradient - map.leftCols<3>()).cwiseAbs().maxCoeff() < 1e-11);
    }
  }

  void weightsOfAnotherMeshAreRefused() {
    const test::Scene scene(test::sphere());
    const test::Scene other(test::cube());
    const Parameterization weights = weightsOf(other);
    QVERIFY_EXCEPTION_THROWN(deformExactly(*scene.mesh, scene.set, weights), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(deformationGradients(*scene.mesh, scene.set, weights), InvalidInput);
  }

  void cancelThrows() {
    test::Scene scene(test::sphere());
    scene.poseAtRandom();
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    const Parameterization weights = weightsOf(scene);
    QVERIFY_EXCEPTION_THROWN(deformExactly(*scene.mesh, scene.set, weights, progress), Cancelled);
    QVERIFY_EXCEPTION_THROWN(deformationGradients(*scene.mesh, scene.set, weights, progress), Cancelled);
  }

 private:
  static Parameterization weightsOf(const test::Scene& scene) {
    return parameterize(*scene.mesh, scene.set.basis, scene.set.master, scene.set.finest());
  }
  static Points deform(const test::Scene& scene) {
    return deformExactly(*scene.mesh, scene.set, weightsOf(scene));
  }
  static std::vector<Mat3> gradients(const test::Scene& scene) {
    return deformationGradients(*scene.mesh, scene.set, weightsOf(scene));
  }

  static void reachAll(ControlSet& set) {
    for (Index j = 0; j < set.finest().size(); ++j) {
      ControlPoint point = set.finest()[j];
      point.reach = Reach::all;
      set.levels[0].replace(j, point);
    }
  }

  /// Any points of space, by the blend of maps.
  static Points deformedSpace(const test::Scene& scene, const Points& at) {
    const PointWeights rows = weightsAt(at, *scene.mesh, scene.set.basis, scene.set.master, scene.set.finest());
    const LevelMaps maps = mapsOf(scene.set, scene.set.finest());
    Points deformed = at;
    for (Index i = 0; i < at.rows(); ++i) {
      deformed.row(i) = applyMap(blendedMap(rows, i, maps), at.row(i));
    }
    return deformed;
  }

  /// The deformation gradient at each vertex by central differences.
  static std::vector<Mat3> differences(const test::Scene& scene) {
    const double h = 1e-6;
    std::vector<Mat3> gradients(static_cast<std::size_t>(scene.mesh->vertexCount()));
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = h * Vec3::Unit(axis);
      const Points ahead = deformedSpace(scene, scene.mesh->positions().rowwise() + step.transpose());
      const Points behind = deformedSpace(scene, scene.mesh->positions().rowwise() - step.transpose());
      for (std::size_t v = 0; v < gradients.size(); ++v) {
        const auto row = static_cast<Index>(v);
        gradients[v].col(axis) = (ahead.row(row) - behind.row(row)).transpose() / (2.0 * h);
      }
    }
    return gradients;
  }

  /// McDonnell & Qin, eq. (7) by the letter: V = WP + DA with dense matrices, the master their last column.
  static Points equationSeven(const test::Scene& scene) {
    const Level& level = scene.set.finest();
    const Points& vertices = scene.mesh->positions();
    const PointWeights rows = weightsAt(vertices, *scene.mesh, scene.set.basis, scene.set.master, level);
    const Index count = level.size() + 1;
    Eigen::MatrixXd w = Eigen::MatrixXd::Zero(vertices.rows(), count);
    for (Index i = 0; i < vertices.rows(); ++i) {
      for (Index e = rows.start[i]; e < rows.start[i + 1]; ++e) {
        w(i, rows.points[e]) = rows.weights[e];
      }
      w(i, count - 1) = rows.master[i];
    }
    Eigen::MatrixXd p(count, 3);
    Eigen::MatrixXd d(vertices.rows(), 3 * count);
    Eigen::MatrixXd a(3 * count, 3);
    for (Index j = 0; j < count; ++j) {
      const Frame& rest = j + 1 < count ? level[j].rest : scene.set.master.rest;
      const Frame& pose = j + 1 < count ? level[j].pose : scene.set.master.pose;
      p.row(j) = pose.center;
      for (int axis = 0; axis < 3; ++axis) {
        a.row(axis * count + j) = pose.axes.col(axis);
        const Vec3 direction = rest.axes.col(axis) / rest.axes.col(axis).squaredNorm();
        d.col(axis * count + j) =
            w.col(j).cwiseProduct((vertices.rowwise() - rest.center.transpose()) * direction);
      }
    }
    return w * p + d * a;
  }
};

const test::Registration<DeformationTest> registration;

}  // namespace pbffd

#include "deformation_test.moc"
