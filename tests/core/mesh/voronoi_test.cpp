#include "core/mesh/voronoi.h"
#include "core/base/error.h"
#include "core/mesh/nearest.h"
#include "core/mesh/spread.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

namespace pbffd {
namespace {

Points randomPoints(Index count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  return Points::NullaryExpr(count, 3, [&](Eigen::Index, Eigen::Index) { return share(random); });
}

/// Each vertex is as far from its sites as it says, and no site is nearer.
void requireDelaunay(const Points& sites, const VoronoiVertices& vertices) {
  const NearestPoints nearest(sites);
  QCOMPARE(static_cast<std::size_t>(vertices.positions.rows()), vertices.radii.size());
  for (Index v = 0; v < vertices.size(); ++v) {
    const Vec3 at = vertices.positions.row(v);
    const double radius = vertices.radii[v];
    QVERIFY(vertices.sites(v).size() >= 4);
    if (radius > 100.0 * (sites.colwise().maxCoeff() - sites.colwise().minCoeff()).maxCoeff()) {
      continue;  // so far away that rounding decides
    }
    const double slack = 1e-9 * radius * std::max(1.0, radius);
    for (const Index site : vertices.sites(v)) {
      QVERIFY(std::abs((sites.row(site).transpose() - at).norm() - radius) <= slack);
    }
    QVERIFY(nearest.nearest(at).distance >= radius - slack);
  }
}

}  // namespace

class VoronoiTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void verticesAreEquidistantAndNoSiteIsNearer() {
    const Points sites = randomPoints(800);
    const VoronoiVertices vertices = voronoiVertices(sites);
    QVERIFY(vertices.size() > 4000);
    requireDelaunay(sites, vertices);
  }

  void cubeHasItsCentre() {
    const VoronoiVertices vertices = voronoiVertices(test::cube().positions);
    QVERIFY(vertices.size() >= 1);
    for (Index v = 0; v < vertices.size(); ++v) {
      QVERIFY(vertices.positions.row(v).norm() < 1e-9);
      QVERIFY(std::abs(vertices.radii[v] - std::sqrt(0.75)) < 1e-9);
    }
  }

  void sphereHasItsCentreOnly() {
    const Points sites = test::sphere(12, 24).positions;
    const VoronoiVertices vertices = voronoiVertices(sites);
    QVERIFY(vertices.size() >= 1);
    for (Index v = 0; v < vertices.size(); ++v) {
      const double norm = vertices.positions.row(v).norm();
      QVERIFY(norm < 1e-6 || norm > 1.0);
    }
  }

  void greatCellsAreCutUp() {
    // Qhull takes minutes where it makes one cell of 20,000 sites.
    const Mesh ball = test::sphere(25, 50);
    const Points sites = test::merged(ball, test::placedAt(ball, 1.0, Vec3(3, 0, 0))).positions;
    const VoronoiVertices vertices = voronoiVertices(sites);
    Index centers = 0;
    for (Index v = 0; v < vertices.size(); ++v) {
      const Vec3 at = vertices.positions.row(v);
      const double off = std::min(at.norm(), (at - Vec3(3, 0, 0)).norm());
      QVERIFY(off < 1e-6 || off > 1.0 - 1e-6);
      QVERIFY(vertices.sites(v).size() <= 40);
      QVERIFY(std::isfinite(vertices.radii[v]));
      centers += off < 1e-6;
    }
    QVERIFY(centers >= 2);
  }

  void regularGridIsNoTrap() {
    Points sites(512, 3);
    for (Index i = 0; i < 512; ++i) {
      sites.row(i) = Vec3(i % 8, i / 8 % 8, i / 64);
    }
    const VoronoiVertices vertices = voronoiVertices(sites);
    requireDelaunay(sites, vertices);
    QVERIFY(vertices.size() >= 343);
  }

  void offsetAndScaleChangeNothing() {
    const Points sites = randomPoints(500);
    const VoronoiVertices reference = voronoiVertices(sites);
    for (const double offset : {1e6, 1e8}) {
      const Points far = sites.array() + offset;
      const VoronoiVertices vertices = voronoiVertices(far);
      QVERIFY(std::abs(vertices.size() - reference.size()) <= reference.size() / 100);
    }
    for (const double scale : {1e-12, 1e12}) {
      const VoronoiVertices vertices = voronoiVertices(scale * sites);
      QCOMPARE(vertices.size(), reference.size());
      QVERIFY(std::abs(vertices.radii[7] / scale / reference.radii[7] - 1.0) < 1e-9);
    }
  }

  void duplicatesCountOnceWithTheLowestRow() {
    const Points sites = randomPoints(300);
    Points twice(600, 3);
    twice << sites, sites;
    const VoronoiVertices reference = voronoiVertices(sites);
    const VoronoiVertices vertices = voronoiVertices(twice);
    QCOMPARE(vertices.siteIndices, reference.siteIndices);
    QVERIFY(vertices.positions == reference.positions);
  }

  void notFiniteIsRefused() {
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Points sites = randomPoints(50);
      sites(20, 1) = bad;
      QVERIFY_EXCEPTION_THROWN(voronoiVertices(sites), InvalidInput);
    }
  }

  void flatThinAndFewSitesAreRefused() {
    Points coplanar = randomPoints(100);
    coplanar.col(2).setConstant(0.3);
    QVERIFY_EXCEPTION_THROWN(voronoiVertices(coplanar), InvalidInput);
    const Points tilted =
        (coplanar * Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).matrix()).array() + 1e6;
    QVERIFY_EXCEPTION_THROWN(voronoiVertices(tilted), InvalidInput);
    const Points collinear = Eigen::VectorXd::LinSpaced(100, 0, 1) * Eigen::RowVector3d(1, 2, 3);
    QVERIFY_EXCEPTION_THROWN(voronoiVertices(collinear), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(voronoiVertices(Points::Constant(100, 3, 7.0)), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(voronoiVertices(randomPoints(3)), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(voronoiVertices(Points(0, 3)), InvalidInput);
  }

  void squashedSitesAreStillSolid() {
    for (const double thickness : {1e-3, 1e-6, 1e-9}) {
      Points sites = randomPoints(200);
      sites.col(2) *= thickness;
      QVERIFY(!areCoplanar(sites));
      QVERIFY(voronoiVertices(sites).size() > 0);
    }
  }

  void progressGrowsAndCancelStopsIt() {
    double last = -1.0;
    bool grows = true;
    const Progress watched([&](std::string_view stage, double share) {
      grows = grows && stage == "Placing points: cells" && share >= last && share <= 1.0;
      last = share;
    });
    voronoiVertices(randomPoints(5000), watched);
    QVERIFY(grows);
    QVERIFY(last > 0.1);

    const Progress stopped([](std::string_view, double) {});
    std::thread stopper([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      stopped.cancel();
    });
    const auto begin = std::chrono::steady_clock::now();
    // Long enough that it would not have ended by itself.
    QVERIFY_EXCEPTION_THROWN(voronoiVertices(randomPoints(200000), stopped), Cancelled);
    QVERIFY(std::chrono::steady_clock::now() - begin < std::chrono::seconds(3));
    stopper.join();
  }
};

const test::Registration<VoronoiTest> registration;

}  // namespace pbffd

#include "voronoi_test.moc"
