#include "core/ffd/placement/placement.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/core/ffd/placement/placed.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace pbffd {
namespace {

using test::place;
using test::rest;
using test::withPoints;

}  // namespace

class PlacementTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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

  void sitesAreASubsetOrAll() {
    PlacementOptions options = withPoints(50);
    for (const int sites : {0, 100, 1000000}) {
      options.sites = sites;
      QCOMPARE(place(test::fork(), options).finest.size(), Index(50));
    }
  }

  void sameInputGivesTheSameBits() {
    const PlacementResult first = place(test::fork(), withPoints(150));
    QVERIFY(first.finest == place(test::fork(), withPoints(150)).finest);
    {
      const ThreadLimit one(1);
      QVERIFY(first.finest == place(test::fork(), withPoints(150)).finest);
    }
    PlacementOptions other = withPoints(150);
    other.seed = 7;
    QVERIFY(place(test::sphere(), other).finest != place(test::sphere(), withPoints(150)).finest);
  }

  void cacheChangesTheTimeAlone() {
    const auto mesh = rest(test::fork());
    const PlacementResult first = placeControlPoints(mesh, withPoints(150));
    PlacementOptions options = withPoints(40);
    options.offset = 0.08;
    const PlacementResult fresh = placeControlPoints(mesh, options);
    QVERIFY(fresh.finest == placeControlPoints(mesh, options, {}, first.cache).finest);
    options.sites = 300;
    options.surface = Surface::open;
    QVERIFY(placeControlPoints(mesh, options).finest ==
            placeControlPoints(mesh, options, {}, first.cache).finest);
    // The cache of another mesh is of no use and does no harm.
    const auto another = rest(test::cylinder());
    QVERIFY(placeControlPoints(another, options).finest ==
            placeControlPoints(another, options, {}, first.cache).finest);
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
