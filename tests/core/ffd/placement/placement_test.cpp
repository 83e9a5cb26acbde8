#include "core/ffd/placement/placement.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/ffd/placement/surface_parts.h"
#include "core/ffd/weights/parameterization.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace pbffd {
namespace {

std::shared_ptr<const RestMesh> rest(Mesh mesh) {
  return std::make_shared<const RestMesh>(std::move(mesh));
}

PlacementOptions withPoints(int points) {
  PlacementOptions options;
  options.points = points;
  return options;
}

PlacementResult place(Mesh mesh, const PlacementOptions& options) {
  return placeControlPoints(rest(std::move(mesh)), options);
}

/// How many vertices of faces no point reaches, and how many points reach none.
struct Gaps {
  int uncovered = 0;
  int idle = 0;
};
Gaps gapsOf(const RestMesh& mesh, const Level& level) {
  std::vector<bool> isReached(static_cast<std::size_t>(mesh.vertexCount()), false);
  Gaps gaps;
  for (const ControlPoint& point : level) {
    const Reached reached = reachedVertices(mesh, point);
    gaps.idle += reached.vertices.empty();
    for (const Index vertex : reached.vertices) {
      isReached[static_cast<std::size_t>(vertex)] = true;
    }
  }
  gaps.uncovered = static_cast<int>(std::count(isReached.begin(), isReached.end(), false));
  return gaps;
}

/// All that the issue of placement promises for any closed mesh.
void requireGuarantees(const Mesh& mesh, const PlacementOptions& options) {
  const auto shared = rest(mesh);
  const PlacementResult result = placeControlPoints(shared, options);
  QCOMPARE(result.finest.size(), Index(options.points));
  QVERIFY(result.asClosed);
  const SurfaceParts parts(shared, Surface::automatic);
  PointId id = 1;
  for (const ControlPoint& point : result.finest) {
    QCOMPARE(point.id, id++);
    QCOMPARE(point.reach, options.reach);
    QVERIFY(point.rest == point.pose);
    QVERIFY(point.kind == PointKind::interior || point.kind == PointKind::exterior);
    QCOMPARE(parts.isInside(point.rest.center), point.kind == PointKind::interior);
    const Mat3 products = point.rest.axes.transpose() * point.rest.axes;
    for (int i = 0; i < 3; ++i) {
      QVERIFY(products(i, i) > 0.0);
      QVERIFY(std::abs(products(i, (i + 1) % 3)) <=
              1e-9 * std::sqrt(products(i, i) * products((i + 1) % 3, (i + 1) % 3)));
    }
  }
  const Gaps gaps = gapsOf(*shared, result.finest);
  QCOMPARE(gaps.uncovered, 0);
  QVERIFY(50 * gaps.idle <= options.points);
}

bool areSame(const Level& a, const Level& b) {
  return a == b;
}

Mesh turnedInsideOut(const Mesh& mesh) {
  Mesh turned;
  turned.positions = mesh.positions;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<Index> face(mesh.faces[f].rbegin(), mesh.faces[f].rend());
    turned.faces.add(face);
  }
  return turned;
}

Mesh stretched(Mesh mesh, const Vec3& factors) {
  mesh.positions = mesh.positions * factors.asDiagonal();
  return mesh;
}

}  // namespace

class PlacementTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void closedShapesKeepAllPromises() {
    for (const int points : {100, 200, 1000}) {
      requireGuarantees(test::cube(), withPoints(points));
      requireGuarantees(test::sphere(), withPoints(points));
      requireGuarantees(test::cylinder(), withPoints(points));
      requireGuarantees(test::fork(), withPoints(points));
    }
  }

  void ellipsoidsAndPaperOptionsKeepThemToo() {
    PlacementOptions options = withPoints(200);
    options.regions = RegionShape::ellipsoid;
    requireGuarantees(test::fork(), options);
    requireGuarantees(test::cube(), options);
    PlacementOptions paper = paperOptions();
    requireGuarantees(test::fork(), paper);
    paper.reach = Reach::connected;
    requireGuarantees(test::fork(), paper);
  }

  void anyNumberIsPlacedExactly() {
    for (const int points : {1, 2, 3, 7, 64, 333, 3000}) {
      QCOMPARE(place(test::cylinder(), withPoints(points)).finest.size(), Index(points));
    }
  }

  void exteriorShareIsKept() {
    for (const double share : {0.0, 0.25, 1.0}) {
      PlacementOptions options = withPoints(80);
      options.exteriorShare = share;
      int exterior = 0;
      for (const ControlPoint& point : place(test::cylinder(), options).finest) {
        exterior += point.kind == PointKind::exterior;
      }
      QCOMPARE(exterior, static_cast<int>(80 * share));
    }
  }

  void insideOutMeshIsTakenTheRightWay() {
    const PlacementResult right = place(test::cylinder(), withPoints(100));
    const auto turned = rest(turnedInsideOut(test::cylinder()));
    const PlacementResult result = placeControlPoints(turned, withPoints(100));
    const SurfaceParts parts(rest(test::cylinder()), Surface::automatic);
    for (const ControlPoint& point : result.finest) {
      QCOMPARE(parts.isInside(point.rest.center), point.kind == PointKind::interior);
    }
    QCOMPARE(result.finest.size(), right.finest.size());
  }

  void hollowStaysEmpty() {
    // A ball with a hollow: the inner shell looks inward.
    const Mesh hollow =
        test::merged(test::sphere(), turnedInsideOut(test::placedAt(test::sphere(), 0.6, Vec3::Zero())));
    int interior = 0;
    for (const ControlPoint& point : place(hollow, withPoints(200)).finest) {
      if (point.kind == PointKind::interior) {
        ++interior;
        QVERIFY(point.rest.center.norm() > 0.59);
      }
    }
    QCOMPARE(interior, 100);
  }

  void openSheetGetsPointsOnBothSides() {
    const PlacementResult result = place(test::sheet(10), withPoints(60));
    QCOMPARE(result.finest.size(), Index(60));
    QVERIFY(!result.asClosed);
    QVERIFY(result.remarks.at(0).find("open") != std::string::npos);
    int above = 0;
    for (const ControlPoint& point : result.finest) {
      QCOMPARE(point.kind, PointKind::exterior);
      above += point.rest.center.z() > 0.0;
    }
    QVERIFY(above > 15 && above < 45);
    QCOMPARE(gapsOf(*rest(test::sheet(10)), result.finest).uncovered, 0);
  }

  void surfaceOverridesWhatTheMeshIs() {
    PlacementOptions options = withPoints(60);
    options.surface = Surface::open;
    const PlacementResult open = place(test::cylinder(), options);
    QVERIFY(!open.asClosed);
    QVERIFY(open.remarks.at(0).find("as asked") != std::string::npos);
    options.surface = Surface::closed;
    QVERIFY(place(test::cylinder(), options).asClosed);
    // A sheet has no inside; all points go outside, and the result says so.
    const PlacementResult sheet = place(test::sheet(10), options);
    QCOMPARE(sheet.finest.size(), Index(60));
    QVERIFY(sheet.remarks.size() >= 2);
  }

  void everyPartGetsPoints() {
    Mesh mesh = test::sphere();
    for (int i = 1; i < 6; ++i) {
      mesh = test::merged(mesh, test::placedAt(test::cube(), 0.1, Vec3(2.0 * i, 0, 0)));
    }
    mesh = test::merged(mesh, test::placedAt(test::sheet(4), 0.3, Vec3(0, 5, 0)));
    const PlacementResult result = place(mesh, withPoints(100));
    QCOMPARE(result.finest.size(), Index(100));
    QVERIFY(result.asClosed);
    for (int i = 0; i < 7; ++i) {
      const Vec3 center = i < 6 ? Vec3(2.0 * i, 0, 0) : Vec3(0, 5, 0);
      const auto isNear = [&](const ControlPoint& point) { return (point.rest.center - center).norm() < 1.9; };
      QVERIFY(std::any_of(result.finest.begin(), result.finest.end(), isNear));
    }
    QVERIFY(result.remarks.at(0).find("6 are closed") != std::string::npos);
    QVERIFY(result.remarks.at(0).find("1 is open") != std::string::npos);
  }

  void morePartsThanPointsShareThem() {
    Mesh mesh = test::cube();
    for (int i = 1; i < 30; ++i) {
      mesh = test::merged(mesh, test::placedAt(test::cube(), 1.0, Vec3(3.0 * i, 0, 0)));
    }
    const PlacementResult result = place(mesh, withPoints(10));
    QCOMPARE(result.finest.size(), Index(10));
    QVERIFY(result.remarks.back().find("30 separate parts") != std::string::npos);
    QCOMPARE(gapsOf(*rest(mesh), result.finest).uncovered, 0);
  }

  void sitesAreASubsetOrAll() {
    PlacementOptions options = withPoints(50);
    for (const int sites : {0, 100, 1000000}) {
      options.sites = sites;
      QCOMPARE(place(test::fork(), options).finest.size(), Index(50));
    }
  }

  void sameInputGivesTheSameBits() {
    const PlacementResult first = place(test::fork(), withPoints(150));
    QVERIFY(areSame(first.finest, place(test::fork(), withPoints(150)).finest));
    {
      const ThreadLimit one(1);
      QVERIFY(areSame(first.finest, place(test::fork(), withPoints(150)).finest));
    }
    PlacementOptions other = withPoints(150);
    other.seed = 7;
    QVERIFY(!areSame(place(test::sphere(), other).finest, place(test::sphere(), withPoints(150)).finest));
  }

  void cacheChangesTheTimeAlone() {
    const auto mesh = rest(test::fork());
    const PlacementResult first = placeControlPoints(mesh, withPoints(150));
    PlacementOptions options = withPoints(40);
    options.offset = 0.08;
    const PlacementResult fresh = placeControlPoints(mesh, options);
    QVERIFY(areSame(fresh.finest, placeControlPoints(mesh, options, {}, first.cache).finest));
    options.sites = 300;
    options.surface = Surface::open;
    QVERIFY(areSame(placeControlPoints(mesh, options).finest,
                    placeControlPoints(mesh, options, {}, first.cache).finest));
    // The cache of another mesh is of no use and does no harm.
    const auto another = rest(test::cylinder());
    QVERIFY(areSame(placeControlPoints(another, options).finest,
                    placeControlPoints(another, options, {}, first.cache).finest));
  }

  void masterEnclosesTheMesh() {
    const auto mesh = rest(test::placedAt(test::cylinder(), 2.0, Vec3(5, 6, 7)));
    const Master master = makeMaster(*mesh, 0.02, MasterMode::paper);
    QCOMPARE(master.value, 0.02);
    QVERIFY(master.rest == master.pose);
    QVERIFY((master.rest.center - mesh->bounds().center()).norm() < 1e-12);
    double farthest = 0.0;
    for (Index v = 0; v < mesh->vertexCount(); ++v) {
      farthest = std::max(farthest, (mesh->positions().row(v).transpose() - master.rest.center).norm());
    }
    QVERIFY(std::abs(master.rest.axes.col(0).norm() - 1.2 * farthest) < 1e-12);
  }

  void farAndTinyMeshesKeepThePromises() {
    requireGuarantees(test::placedAt(test::fork(), 1.0, Vec3::Constant(1e8)), withPoints(100));
    requireGuarantees(test::placedAt(test::fork(), 1e-12, Vec3::Zero()), withPoints(100));
    requireGuarantees(test::placedAt(test::fork(), 1e12, Vec3::Zero()), withPoints(100));
  }

  void squashedSolidsGetAsManyAsAskedFor() {
    for (const Vec3& factors : {Vec3(1, 1, 1e-3), Vec3(1, 1e3, 1e-3), Vec3(1, 1e6, 1)}) {
      requireGuarantees(stretched(test::sphere(), factors), withPoints(100));
    }
  }

  void wildlyStretchedMeshesGetPointsInside() {
    const Mesh fork = test::fork();
    const SurfaceParts plain(rest(fork), Surface::automatic);
    for (const Vec3& factors : {Vec3(1e6, 1, 1), Vec3(1, 1, 1e-6)}) {
      requireGuarantees(stretched(fork, factors), withPoints(100));
      // Sides are the same in the mesh as it was.
      for (const ControlPoint& point : place(stretched(fork, factors), withPoints(100)).finest) {
        const Vec3 at = point.rest.center.cwiseQuotient(factors);
        QCOMPARE(plain.isInside(at), point.kind == PointKind::interior);
      }
    }
  }

  void verticesWithoutFacesDoNotMatter() {
    Mesh mesh = test::cylinder();
    const PlacementResult without = place(mesh, withPoints(60));
    mesh.positions.conservativeResize(mesh.positions.rows() + 1, 3);
    mesh.positions.bottomRows(1) << 1e6, 1e6, 1e6;
    QVERIFY(areSame(place(mesh, withPoints(60)).finest, without.finest));
  }

  void shellsInTheSamePlaceShareNoPoint() {
    const PlacementResult result = place(test::merged(test::fork(), test::fork()), withPoints(100));
    QCOMPARE(result.finest.size(), Index(100));
    std::set<std::array<double, 3>> places;
    for (const ControlPoint& point : result.finest) {
      places.insert({point.rest.center.x(), point.rest.center.y(), point.rest.center.z()});
      QVERIFY(point.rest.axes.col(0).norm() < 3.0);
    }
    QCOMPARE(places.size(), std::size_t{100});
  }

  void manySmallPartsGetAPointInsideEach() {
    Mesh mesh = test::placedAt(test::sheet(20), 10.0, Vec3(0, 0, -1));
    for (int i = 0; i < 30; ++i) {
      mesh = test::merged(mesh, test::placedAt(test::cube(), 0.2, Vec3(i % 6 - 2.5, i / 6 - 2.0, 0.0)));
    }
    const PlacementResult result = place(mesh, withPoints(80));
    QCOMPARE(result.finest.size(), Index(80));
    for (int i = 0; i < 30; ++i) {
      const Vec3 center(i % 6 - 2.5, i / 6 - 2.0, 0.0);
      const auto isInCube = [&](const ControlPoint& point) {
        return (point.rest.center - center).cwiseAbs().maxCoeff() < 0.1;
      };
      QVERIFY(std::any_of(result.finest.begin(), result.finest.end(), isInCube));
    }
  }

  void facesThatDisagreeAreNamed() {
    Mesh mesh;
    mesh.positions = test::cylinder().positions;
    const Mesh cylinder = test::cylinder();
    for (Index f = 0; f < cylinder.faces.size(); ++f) {
      std::vector<Index> face(cylinder.faces[f].begin(), cylinder.faces[f].end());
      if (f % 2 == 0) {
        std::reverse(face.begin(), face.end());
      }
      mesh.faces.add(face);
    }
    const PlacementResult result = place(mesh, withPoints(60));
    QCOMPARE(result.finest.size(), Index(60));
    QVERIFY(!result.asClosed);
    QVERIFY(result.remarks.at(1).find("do not agree on which side is out") != std::string::npos);
    QCOMPARE(gapsOf(*rest(mesh), result.finest).uncovered, 0);
  }

  void tooLittleRoomInsideIsSaid() {
    Mesh mesh = test::placedAt(test::cube(), 0.01, Vec3::Zero());
    for (int i = 1; i < 40; ++i) {
      mesh = test::merged(mesh, test::placedAt(test::cube(), 0.01, Vec3(i, 0.3 * i, 0)));
    }
    const PlacementResult result = place(mesh, withPoints(5000));
    int inside = 0;
    for (const ControlPoint& point : result.finest) {
      inside += point.kind == PointKind::interior;
    }
    const bool isSaid =
        std::any_of(result.remarks.begin(), result.remarks.end(),
                    [](const std::string& remark) { return remark.find("room inside") != std::string::npos; });
    QCOMPARE(isSaid, inside < 2500);
  }

  void facesWithoutAreaAreRefused() {
    Mesh mesh;
    mesh.positions = test::cube().positions;
    mesh.faces.add(std::vector<Index>{0, 1, 1});
    mesh.faces.add(std::vector<Index>{2, 7, 2});
    try {
      place(mesh, withPoints(10));
      QFAIL("placed");
    } catch (const InvalidInput& error) {
      QVERIFY(std::string(error.what()).find("area") != std::string::npos);
    }
  }

  void closedMeshWithoutVolumeGetsPointsOutside() {
    const Mesh flat = stretched(test::cube(), Vec3(1, 1, 0));
    const PlacementResult result = place(flat, withPoints(40));
    QCOMPARE(result.finest.size(), Index(40));
    QCOMPARE(gapsOf(*rest(flat), result.finest).uncovered, 0);
  }

  void tooLittleToPlaceOnIsRefused() {
    Mesh cloud;
    cloud.positions = Points::Random(20, 3);
    QVERIFY_EXCEPTION_THROWN(place(cloud, withPoints(10)), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(place(Mesh(), withPoints(10)), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(place(stretched(test::cube(), Vec3(1, 0, 0)), withPoints(10)), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(place(stretched(test::cube(), Vec3(0, 0, 0)), withPoints(10)), InvalidInput);
    Mesh broken = test::cube();
    broken.positions(3, 1) = std::numeric_limits<double>::quiet_NaN();
    try {
      place(broken, withPoints(10));
      QFAIL("no error");
    } catch (const InvalidInput& error) {
      QVERIFY(std::string(error.what()).find("vertex 3") != std::string::npos);
    }
  }

  void sizesBeyondDoublePrecisionAreRefused() {
    for (const double scale : {1e150, 1e-150}) {
      try {
        place(test::placedAt(test::cube(), scale, Vec3::Zero()), withPoints(10));
        QFAIL("placed");
      } catch (const InvalidInput& error) {
        QVERIFY(std::string_view(error.what()).find("diagonal") != std::string_view::npos);
      }
    }
  }

  void optionsOutOfRangeAreRefusedByName() {
    const auto refused = [](const auto& change, const std::string& name) {
      PlacementOptions options;
      change(options);
      try {
        requireValid(options);
      } catch (const InvalidInput& error) {
        return std::string(error.what()).find(name) != std::string::npos;
      }
      return false;
    };
    requireValid({});
    requireValid(paperOptions());
    QVERIFY(refused([](auto& o) { o.points = 0; }, "points"));
    QVERIFY(refused([](auto& o) { o.points = 20001; }, "points"));
    QVERIFY(refused([](auto& o) { o.levels = 0; }, "levels"));
    QVERIFY(refused([](auto& o) { o.basis.sigma = 0.0; }, "sigma"));
    QVERIFY(refused([](auto& o) { o.master = -1.0; }, "master"));
    QVERIFY(refused([](auto& o) { o.radiusFactor = 0.0; }, "radius factor"));
    QVERIFY(refused([](auto& o) { o.offset = std::numeric_limits<double>::quiet_NaN(); }, "offset"));
    QVERIFY(refused([](auto& o) { o.exteriorShare = 1.1; }, "exterior share"));
    QVERIFY(refused([](auto& o) { o.sites = -1; }, "sites"));
  }

  void stagesAreReportedAndEachCanBeCancelled() {
    const auto mesh = rest(test::fork());
    std::set<std::string> stages;
    std::mutex mutex;
    placeControlPoints(mesh, withPoints(100), Progress([&](std::string_view stage, double) {
                         const std::lock_guard lock(mutex);
                         stages.emplace(stage);
                       }));
    QVERIFY(stages.size() >= 5);
    for (const std::string& wanted : stages) {
      QVERIFY(wanted.starts_with("Placing points: "));
      // The handle is known to the listener only once it is made.
      const auto handle = std::make_shared<std::atomic<const Progress*>>(nullptr);
      const Progress progress([&wanted, handle](std::string_view stage, double) {
        if (stage == wanted && handle->load() != nullptr) {
          handle->load()->cancel();
        }
      });
      handle->store(&progress);
      QVERIFY_EXCEPTION_THROWN(placeControlPoints(mesh, withPoints(100), progress), Cancelled);
    }
  }
};

const test::Registration<PlacementTest> registration;

}  // namespace pbffd

#include "placement_test.moc"
