#include "core/ffd/deform/space_deformation.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/ffd/deform/deformation.h"
#include "core/ffd/weights/parameterization.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <random>

namespace pbffd {
namespace {

constexpr double tolerance = 1e-13;

/// Regions of several sizes and turns around some of the mesh's vertices, all but every third one moved.
ControlSet posedSet(const RestMesh& mesh, int count, Kernel kernel, MasterMode mode = MasterMode::constant) {
  ControlSet set;
  set.basis.kernel = kernel;
  set.master.mode = mode;
  set.master.rest.center = mesh.bounds().center();
  set.master.rest.axes = 0.6 * mesh.diagonal() * Mat3::Identity();
  set.master.pose = set.master.rest;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto vector = [&] { return Vec3(number(random), number(random), number(random)); };
  for (int j = 0; j < count; ++j) {
    ControlPoint point;
    point.id = j + 1;
    point.strength = 1.0 + 0.1 * j;
    point.reach = j % 2 == 0 ? Reach::connected : Reach::all;
    const Eigen::Index vertex = (j * 97) % mesh.vertexCount();
    point.rest.center = mesh.positions().row(vertex).transpose() + 0.05 * vector();
    const Mat3 turn = Eigen::AngleAxisd(number(random), vector().normalized()).matrix();
    point.rest.axes = turn * Vec3(0.5 + 0.2 * number(random), 0.6, 0.7).asDiagonal();
    point.pose = point.rest;
    if (j % 3 != 0) {
      point.pose.center += 0.2 * vector();
      point.pose.axes = Eigen::AngleAxisd(0.5 * number(random), vector().normalized()) * point.pose.axes;
    }
    set.levels[0].append(point);
  }
  return set;
}

Points randomPlaces(const RestMesh& mesh, Eigen::Index count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(-0.2, 1.2);
  Points places(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3 at(share(random), share(random), share(random));
    places.row(i) = mesh.bounds().low + at.cwiseProduct(mesh.bounds().high - mesh.bounds().low);
  }
  return places;
}

std::shared_ptr<const RestMesh> rest(Mesh mesh) {
  return std::make_shared<const RestMesh>(std::move(mesh));
}

}  // namespace

class SpaceDeformationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void unmovedSetLeavesEveryBit() {
    const auto mesh = rest(test::sphere());
    ControlSet set = posedSet(*mesh, 10, Kernel::smooth);
    for (Index j = 0; j < set.levels[0].size(); ++j) {
      ControlPoint point = set.levels[0][j];
      point.pose = point.rest;
      set.levels[0].replace(j, point);
    }
    const SpaceDeformation space(mesh, set);
    QVERIFY(!space.movesAnything());
    const Points places = randomPlaces(*mesh, 100);
    QVERIFY(space.positions(places) == places);
    QVERIFY(space.image(places).gradients[5] == Mat3::Identity());
    QCOMPARE(space.positions(Points(0, 3)).rows(), Eigen::Index{0});
  }

  void kernels_data() {
    QTest::addColumn<int>("kernel");
    QTest::addColumn<int>("mode");
    const auto row = [](const char* name, Kernel kernel, MasterMode mode) {
      QTest::newRow(name) << static_cast<int>(kernel) << static_cast<int>(mode);
    };
    row("smooth", Kernel::smooth, MasterMode::constant);
    row("wendland", Kernel::wendland, MasterMode::constant);
    row("gaussian, the paper's master", Kernel::gaussian, MasterMode::paper);
  }

  void placesAreTheBlendOfTheirWeights_data() { kernels_data(); }
  void placesAreTheBlendOfTheirWeights() {
    QFETCH(int, kernel);
    QFETCH(int, mode);
    const auto mesh = rest(test::fork());
    const ControlSet set = posedSet(*mesh, 24, static_cast<Kernel>(kernel), static_cast<MasterMode>(mode));
    const Points places = randomPlaces(*mesh, 3000);
    const Points moved = SpaceDeformation(mesh, set).positions(places);
    const PointWeights weights = weightsAt(places, *mesh, set.basis, set.master, set.finest());
    const LevelMaps maps = mapsOf(set, set.finest());
    int movedPlaces = 0;
    for (Index i = 0; i < places.rows(); ++i) {
      const Vec3 expected = applyMap(blendedMap(weights, i, maps), places.row(i).transpose());
      QVERIFY((expected - moved.row(i).transpose()).norm() < tolerance * mesh->diagonal());
      movedPlaces += places.row(i) != moved.row(i);
    }
    QVERIFY(movedPlaces > 500);
  }

  void verticesGoWhereTheMeshGoesToTheLastBit_data() { kernels_data(); }
  void verticesGoWhereTheMeshGoesToTheLastBit() {
    QFETCH(int, kernel);
    QFETCH(int, mode);
    const auto mesh = rest(test::fork());
    const ControlSet set = posedSet(*mesh, 24, static_cast<Kernel>(kernel), static_cast<MasterMode>(mode));
    const Parameterization weights = parameterize(*mesh, set.basis, set.master, set.finest());
    const SpaceImage image = SpaceDeformation(mesh, set).image(mesh->positions());
    QVERIFY(image.positions == deformExactly(*mesh, set, weights));
    const std::vector<Mat3> gradients = deformationGradients(*mesh, set, weights);
    for (std::size_t v = 0; v < gradients.size(); ++v) {
      QVERIFY((gradients[v] - image.gradients[v]).norm() < tolerance);
    }
  }

  void gradientIsTheDerivative_data() { kernels_data(); }
  void gradientIsTheDerivative() {
    QFETCH(int, kernel);
    QFETCH(int, mode);
    const auto mesh = rest(test::sphere());
    const ControlSet set = posedSet(*mesh, 24, static_cast<Kernel>(kernel), static_cast<MasterMode>(mode));
    const SpaceDeformation space(mesh, set, ReachRule::all);
    const Points places = randomPlaces(*mesh, 500);
    const SpaceImage image = space.image(places);
    constexpr double step = 1e-6;
    std::array<Points, 3> slopes;
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::RowVector3d shift = step * Eigen::RowVector3d::Unit(axis);
      slopes[static_cast<std::size_t>(axis)] =
          (space.positions(places.rowwise() + shift) - space.positions(places.rowwise() - shift)) / (2 * step);
    }
    int bent = 0;
    for (Eigen::Index i = 0; i < places.rows(); ++i) {
      Mat3 slope;
      slope << slopes[0].row(i).transpose(), slopes[1].row(i).transpose(), slopes[2].row(i).transpose();
      const Mat3& gradient = image.gradients[static_cast<std::size_t>(i)];
      // A gaussian ends with a step at the border of its region; a difference across it is no derivative.
      const bool isAtBorder = slope.norm() > 100.0;
      QVERIFY(isAtBorder || (slope - gradient).norm() < 1e-6);
      bent += (gradient - Mat3::Identity()).norm() > 0.01;
    }
    QVERIFY(bent > 100);
  }

  void oneMapOfEverythingCarriesEveryPlaceExactly() {
    const auto mesh = rest(test::sphere());
    ControlSet set = posedSet(*mesh, 24, Kernel::smooth);
    const AffineMap map =
        makeMap(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * Vec3(1.5, 0.7, 1.1).asDiagonal(),
                Vec3(0.3, -2.0, 1.0));
    for (Index j = 0; j < set.levels[0].size(); ++j) {
      ControlPoint point = set.levels[0][j];
      point.pose = moved(point.rest, map);
      set.levels[0].replace(j, point);
    }
    set.master.pose = moved(set.master.rest, map);
    const Points places = randomPlaces(*mesh, 1000);
    const SpaceImage image = SpaceDeformation(mesh, set).image(places);
    for (Eigen::Index i = 0; i < places.rows(); ++i) {
      const Vec3 expected = applyMap(map, places.row(i).transpose());
      QVERIFY((expected - image.positions.row(i).transpose()).norm() < 1e-12 * mesh->diagonal());
      QVERIFY((image.gradients[static_cast<std::size_t>(i)] - map.leftCols<3>()).norm() < 1e-12);
    }
  }

  void bitsDependNeitherOnThreadsNorOnPortions() {
    const auto mesh = rest(test::fork());
    const SpaceDeformation space(mesh, posedSet(*mesh, 24, Kernel::smooth));
    const Points places = randomPlaces(*mesh, 70000);
    const Points together = space.positions(places);
    {
      const ThreadLimit one(1);
      QVERIFY(space.positions(places) == together);
    }
    for (const Eigen::Index first : {0, 1, 31000, 69999}) {
      const Eigen::Index rows = std::min<Eigen::Index>(999, places.rows() - first);
      QVERIFY(space.positions(places.middleRows(first, rows)) == together.middleRows(first, rows));
    }
    QVERIFY(space.image(places).positions == together);
  }

  void connectedLeavesWhatIsNearTheOtherArm() {
    const auto mesh = rest(test::fork(0.2));
    ControlSet set;
    ControlPoint point;
    const Index tip = farthestAlong(mesh->positions(), -1.0);
    point.rest.center = mesh->positions().row(tip);
    point.rest.axes = 2.0 * Mat3::Identity();
    point.pose = point.rest;
    point.pose.center.z() += 1.0;
    set.levels[0].append(point);
    const Index otherTip = farthestAlong(mesh->positions(), 1.0);
    Points places(2, 3);
    places << mesh->positions().row(tip), mesh->positions().row(otherTip);
    places.col(2).array() += 1e-4;
    const Points connected = SpaceDeformation(mesh, set).positions(places);
    QVERIFY(connected(0, 2) > places(0, 2) + 0.9);
    QVERIFY(connected.row(1) == places.row(1));
    const Points all = SpaceDeformation(mesh, set, ReachRule::all).positions(places);
    QVERIFY(all.row(0) == connected.row(0));
    QVERIFY(all(1, 2) > places(1, 2) + 0.1);
  }

  void disabledPointsAreAbsent() {
    const auto mesh = rest(test::sphere());
    ControlSet set = posedSet(*mesh, 24, Kernel::smooth);
    ControlSet without = set;
    without.levels[0].remove(4);
    ControlPoint disabled = set.levels[0][4];
    disabled.enabled = false;
    set.levels[0].replace(4, disabled);
    const Points places = randomPlaces(*mesh, 1000);
    QVERIFY(SpaceDeformation(mesh, set).positions(places) == SpaceDeformation(mesh, without).positions(places));
  }

  void placesThatAreNoNumbersStaySo() {
    const auto mesh = rest(test::sphere());
    const ControlSet set = posedSet(*mesh, 24, Kernel::smooth);
    Points places = randomPlaces(*mesh, 40);
    const Points expected = SpaceDeformation(mesh, set).positions(places);
    places(7, 1) = std::numeric_limits<double>::quiet_NaN();
    places(8, 0) = std::numeric_limits<double>::infinity();
    const Points moved = SpaceDeformation(mesh, set).positions(places);
    QVERIFY(std::isnan(moved(7, 1)) && moved.row(8) == places.row(8));
    QVERIFY(moved.bottomRows(31) == expected.bottomRows(31));
  }

  void cancelledWorkThrows() {
    const auto mesh = rest(test::sphere());
    const ControlSet set = posedSet(*mesh, 10, Kernel::smooth);
    const Progress progress([](std::string_view, double) {});
    const SpaceDeformation space(mesh, set, ReachRule::asStored, progress);
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(space.positions(mesh->positions(), progress), Cancelled);
    QVERIFY_EXCEPTION_THROWN(SpaceDeformation(mesh, set, ReachRule::asStored, progress), Cancelled);
  }

 private:
  /// The vertex that is farthest along x and, of these, lies towards `side` in y.
  static Index farthestAlong(const Points& positions, double side) {
    Index best = 0;
    for (Index v = 1; v < positions.rows(); ++v) {
      const auto value = [&](Index i) { return positions(i, 0) + 1e-3 * side * positions(i, 1); };
      best = value(v) > value(best) ? v : best;
    }
    return best;
  }
};

const test::Registration<SpaceDeformationTest> registration;

}  // namespace pbffd

#include "space_deformation_test.moc"
