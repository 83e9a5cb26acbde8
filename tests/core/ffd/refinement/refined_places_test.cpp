#include "core/ffd/refinement/refined_places.h"

#include "core/base/error.h"
#include "core/ffd/basis.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <set>

namespace pbffd {
namespace {

/// A placed fork and the pools for refining every third of its points.
struct Ground {
  std::shared_ptr<const RestMesh> mesh = std::make_shared<const RestMesh>(test::fork());
  PlacementResult placed;
  std::vector<Index> places;
  RefinementTask task{placed.finest, places, 3};
  std::shared_ptr<const PlacementCache> cache;
  RefinementPools pools;

  Ground() {
    PlacementOptions options;
    options.points = 60;
    placed = placeControlPoints(mesh, options);
    cache = placed.cache;
    for (Index i = 0; i < placed.finest.size(); i += 3) {
      places.push_back(i);
    }
    pools = refinementPools(mesh, task, options, cache, {});
  }

  std::vector<RefinedPlace> chosen() const { return refinedPlaces(task, pools, *mesh, {}); }
  const ControlPoint& point(Index place) const { return placed.finest[place]; }
};

bool isIn(const PointPool& pool, const Vec3& center) {
  for (Index i = 0; i < pool.size(); ++i) {
    if (pool.points.row(i).transpose() == center) {
      return true;
    }
  }
  return false;
}

}  // namespace

class RefinedPlacesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void poolsOfPlacementAreUsedAgain() {
    const Ground ground;
    QVERIFY(ground.cache->interior == ground.placed.cache->interior);
    QVERIFY(ground.pools.parts == ground.placed.cache->parts);
    QCOMPARE(ground.pools.inside.size(), ground.cache->interior->size());
  }

  void exteriorPlacesComeNearerForSmallRegions() {
    const auto mesh = std::make_shared<const RestMesh>(test::sphere());
    Level level;
    level.append(test::pointAt(1, Vec3(0, 0, 1), 0.2));
    const std::vector<Index> places{0};
    std::shared_ptr<const PlacementCache> cache;
    const RefinementPools pools = refinementPools(mesh, {level, places, 4}, PlacementOptions(), cache, {});
    // Half of 0.2 over the root of 4.
    for (Index i = 0; i < pools.outside.size(); ++i) {
      QVERIFY(std::abs(pools.outside.points.row(i).norm() - 1.05) < 0.01);
    }
    QCOMPARE(cache->offset, PlacementOptions().offset);
  }

  void eachPlaceIsInTheRegionThatItRefines() {
    const Ground ground;
    const std::set<Index> refined(ground.places.begin(), ground.places.end());
    for (const RefinedPlace& one : ground.chosen()) {
      QVERIFY(refined.contains(one.refines));
      const ControlPoint& owner = ground.point(one.refines);
      QVERIFY(Region(owner.rest).squaredDistance(one.center) < 1.0);
      QVERIFY(!ground.pools.parts->isBetween(owner.rest.center, one.center));
      for (const ControlPoint& other : ground.placed.finest) {
        QVERIFY(other.kind != owner.kind ||
                (other.rest.center - one.center).norm() >= (owner.rest.center - one.center).norm());
      }
    }
  }

  void placesAreThoseOfThePoolOfTheirSide() {
    const Ground ground;
    for (const RefinedPlace& one : ground.chosen()) {
      const bool isInside = ground.point(one.refines).kind == PointKind::interior;
      QVERIFY(isIn(isInside ? ground.pools.inside : ground.pools.outside, one.center));
      QCOMPARE(ground.pools.parts->isInside(one.center), isInside);
    }
  }

  void thereAreFactorTimesAsMany() {
    const Ground ground;
    QCOMPARE(ground.chosen().size(), 2 * ground.places.size());
  }

  void placesStandApart() {
    const Ground ground;
    const std::vector<RefinedPlace> chosen = ground.chosen();
    for (const RefinedPlace& one : chosen) {
      const double least = 0.15 * sizeOf(ground.point(one.refines).rest) / std::sqrt(3.0);
      for (const ControlPoint& other : ground.placed.finest) {
        QVERIFY(other.kind != ground.point(one.refines).kind ||
                (other.rest.center - one.center).norm() >= least);
      }
      for (const RefinedPlace& other : chosen) {
        if (&other != &one && ground.point(other.refines).kind == ground.point(one.refines).kind) {
          QVERIFY((other.center - one.center).norm() >=
                  std::min(least, 0.15 * sizeOf(ground.point(other.refines).rest) / std::sqrt(3.0)));
        }
      }
    }
  }

  void poolsThatAreUsedUpGiveFewer() {
    Ground ground;
    ground.pools.inside = {};
    PointPool two;
    two.append(ground.chosen().front().center, 0);
    two.append(ground.chosen().front().center, 0);
    ground.pools.outside = two;
    // The second stands where the first was taken.
    QCOMPARE(ground.chosen().size(), std::size_t{1});
    ground.pools.outside = {};
    QVERIFY(ground.chosen().empty());
  }

  void lineInsideGetsPlacesBesideIt() {
    const auto mesh = std::make_shared<const RestMesh>(test::cylinder());
    Level level;
    level.append(test::pointAt(1, Vec3(2, 0, 0), 1.0));
    const std::vector<Index> places{0};
    const RefinementTask task{level, places, 8};
    std::shared_ptr<const PlacementCache> cache;
    RefinementPools pools = refinementPools(mesh, task, PlacementOptions(), cache, {});
    const double radius = mesh->positions().rightCols(2).rowwise().norm().maxCoeff();
    const auto besideAxis = [&] {
      return (pools.inside.points.rightCols(2).rowwise().norm().array() > 0.5 * radius).count();
    };
    const auto before = besideAxis();
    spreadInside(pools, task, 40, 0, {});
    QVERIFY(besideAxis() > 2 * before + 40);
    for (Index i = 0; i < pools.inside.size(); ++i) {
      QVERIFY(pools.parts->isInside(pools.inside.points.row(i)));
    }
  }

  void sizesAreThoseOfTheBallOfTheSameVolume() {
    QCOMPARE(sizeOf({Vec3::Zero(), Mat3(Vec3(1, 2, 4).asDiagonal())}), 2.0);
    QCOMPARE(greatestShare(8), 0.5);
  }

  void choosingCanBeCancelled() {
    const Ground ground;
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(refinedPlaces(ground.task, ground.pools, *ground.mesh, progress), Cancelled);
  }
};

const test::Registration<RefinedPlacesTest> registration;

}  // namespace pbffd

#include "refined_places_test.moc"
