#include "core/ffd/refinement/refinement.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/ffd/deform/deformation.h"
#include "core/ffd/refinement/refined_places.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/bend.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>
#include <random>

namespace pbffd {
namespace {

/// A mesh with placed points.
struct Placed {
  std::shared_ptr<const RestMesh> mesh;
  PlacementOptions options;
  ControlSet set;
  std::shared_ptr<const PlacementCache> cache;

  explicit Placed(Mesh shape, int points = 60, unsigned seed = 0)
      : mesh(std::make_shared<const RestMesh>(std::move(shape))) {
    options.points = points;
    options.seed = seed;
    const PlacementResult placed = placeControlPoints(mesh, options);
    set.master = placed.master;
    set.levels = {placed.finest};
    cache = placed.cache;
  }

  /// Each point and the master under the map of its own place.
  template <class MapAt>
  void pose(const MapAt& mapAt) {
    for (Index i = 0; i < set.levels[0].size(); ++i) {
      ControlPoint point = set.levels[0][i];
      point.pose = moved(point.rest, mapAt(point.rest.center));
      set.levels[0].replace(i, point);
    }
    set.master.pose = moved(set.master.rest, mapAt(set.master.rest.center));
  }

  Refinement refined(const std::vector<Index>& places, int factor) const {
    return refinedPoints(mesh, set, places, {options, factor}, {}, cache);
  }

  /// How far the surface moves when the points are added, as a share of the diagonal.
  double changeBy(const Refinement& refinement) const {
    ControlSet after = set;
    for (const RefinedPoint& one : refinement.points) {
      after.levels[0].append(one.point);
    }
    const auto deformed = [&](const ControlSet& one) {
      return deformExactly(*mesh, one, parameterize(*mesh, one.basis, one.master, one.finest()));
    };
    return (deformed(after) - deformed(set)).rowwise().norm().maxCoeff() / mesh->diagonal();
  }
};

std::vector<Index> every(int step, const Placed& placed) {
  std::vector<Index> places;
  for (Index i = 0; i < placed.set.finest().size(); i += step) {
    places.push_back(i);
  }
  return places;
}

Mesh shapeCalled(const QString& name) {
  return name == "bar" ? test::cylinder(4.0, 0.5, 60) : name == "fork" ? test::fork() : test::sheet(20);
}

void shapesAndFactors() {
  QTest::addColumn<QString>("shape");
  QTest::addColumn<int>("points");
  QTest::addColumn<int>("step");
  QTest::addColumn<int>("factor");
  QTest::newRow("bar, all, 2") << "bar" << 100 << 1 << 2;
  QTest::newRow("bar, few, 2") << "bar" << 20 << 3 << 2;
  QTest::newRow("bar, few, 16") << "bar" << 30 << 5 << 16;
  QTest::newRow("fork, all, 2") << "fork" << 100 << 1 << 2;
  QTest::newRow("fork, some, 5") << "fork" << 60 << 4 << 5;
  QTest::newRow("sheet, some, 3") << "sheet" << 60 << 2 << 3;
}

}  // namespace

class RefinementTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void looseVerticesCountForNothing() {
    Mesh shape = test::cylinder(4.0, 0.5, 60);
    const Index count = shape.vertexCount();
    constexpr Index loose = 4000;
    shape.positions.conservativeResize(count + loose, 3);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    for (Index i = 0; i < loose; ++i) {
      shape.positions.row(count + i) = Vec3(2.0 + 2.5 * share(random), 1.5 * share(random), 1.5 * share(random));
    }
    Placed placed(shape, 60);
    const Refinement refinement = placed.refined(every(10, placed), 16);
    QVERIFY(!refinement.points.empty());
    for (const RefinedPoint& one : refinement.points) {
      const Region region(one.point.rest);
      bool isTouched = false;
      for (Index v = 0; v < count && !isTouched; ++v) {
        isTouched = region.squaredDistance(shape.positions.row(v)) < 1.0;
      }
      QVERIFY(isTouched);
    }
  }

  void affineDeformationDoesNotChange_data() { shapesAndFactors(); }

  void affineDeformationDoesNotChange() {
    QFETCH(QString, shape);
    QFETCH(int, points);
    QFETCH(int, step);
    QFETCH(int, factor);
    Placed placed(shapeCalled(shape), points);
    Mat3 linear;
    linear << 1.2, 0.3, -0.1, 0.2, 0.7, 0.4, -0.3, 0.1, 1.5;
    const AffineMap map = makeMap(linear, Vec3(3, -2, 5));
    placed.pose([&](const Vec3&) { return map; });
    const Refinement refinement = placed.refined(every(step, placed), factor);
    QVERIFY(!refinement.points.empty());
    QVERIFY(placed.changeBy(refinement) < 1e-12);
  }

  void bendChangesByLessThanAHundredthOfTheDiagonal_data() { shapesAndFactors(); }

  void bendChangesByLessThanAHundredthOfTheDiagonal() {
    QFETCH(QString, shape);
    QFETCH(int, points);
    QFETCH(int, step);
    QFETCH(int, factor);
    Placed placed(shapeCalled(shape), points);
    placed.pose([&](const Vec3& place) { return test::bendAt(place, placed.mesh->bounds(), 120.0); });
    const Refinement refinement = placed.refined(every(step, placed), factor);
    const double change = placed.changeBy(refinement);
    QVERIFY(change <= 0.005 + 1e-12);
    QVERIFY(std::abs(change - refinement.change / placed.mesh->diagonal()) < 1e-12);
    for (const RefinedPoint& one : refinement.points) {
      QVERIFY(!reachedVertices(*placed.mesh, one.point).vertices.empty());
    }
  }

  void thereAreFactorTimesAsManyAndTheyAreSmaller() {
    const Placed placed(test::fork(), 60);
    for (const int factor : {2, 4}) {
      const std::vector<Index> places = every(4, placed);
      const Refinement refinement = placed.refined(places, factor);
      QCOMPARE(refinement.points.size(), places.size() * static_cast<std::size_t>(factor - 1));
      for (const RefinedPoint& one : refinement.points) {
        const ControlPoint& refined = placed.set.finest()[one.refines];
        QVERIFY(sizeOf(one.point.rest) <= greatestShare(factor) * sizeOf(refined.rest) * (1.0 + 1e-12));
        QVERIFY(one.point.pose == one.point.rest);
        QVERIFY(!reachedVertices(*placed.mesh, one.point).vertices.empty());
      }
    }
  }

  void whatIsNotOfThePlaceIsInherited() {
    Placed placed(test::cylinder(), 40);
    ControlPoint point = placed.set.levels[0][7];
    point.reach = Reach::all;
    point.strength = 3.0;
    point.locked = true;
    placed.set.levels[0].replace(7, point);
    const Refinement refinement = placed.refined({7}, 3);
    QCOMPARE(refinement.points.size(), std::size_t{2});
    for (const RefinedPoint& one : refinement.points) {
      QCOMPARE(one.refines, 7);
      QVERIFY(one.point.reach == Reach::all);
      QVERIFY(one.point.kind == point.kind);
      QCOMPARE(one.point.strength, 6.0);
      QVERIFY(one.point.enabled);
      QVERIFY(!one.point.locked);
      QVERIFY(one.point.name.empty());
    }
  }

  void newPointsMoveTheSurfaceNoLessThanThoseTheyRefine() {
    const Placed placed(test::fork(), 60);
    const std::vector<Index> places = every(2, placed);
    const Refinement refinement = placed.refined(places, 2);
    Level with = placed.set.finest();
    for (const RefinedPoint& one : refinement.points) {
      with.append(one.point);
    }
    const auto share = [&](const Level& level, Index place) {
      Points at(1, 3);
      at.row(0) =
          placed.mesh->positions().row(placed.mesh->nearestVertex().nearest(level[place].rest.center).index);
      const PointWeights weights = weightsAt(at, *placed.mesh, placed.set.basis, placed.set.master, level);
      const auto found = std::find(weights.points.begin(), weights.points.end(), place);
      return found == weights.points.end()
                 ? 0.0
                 : weights.weights[static_cast<std::size_t>(found - weights.points.begin())];
    };
    double before = 0.0;
    for (const Index place : places) {
      before += share(placed.set.finest(), place) / static_cast<double>(places.size());
    }
    double after = 0.0;
    for (Index i = placed.set.finest().size(); i < with.size(); ++i) {
      after += share(with, i) / static_cast<double>(refinement.points.size());
    }
    QVERIFY(after > 0.8 * before);
  }

  void pointsComeByThePointThatTheyRefine() {
    const Placed placed(test::fork(), 60);
    const Refinement refinement = placed.refined({20, 5, 11}, 3);
    std::vector<Index> refined;
    for (const RefinedPoint& one : refinement.points) {
      refined.push_back(one.refines);
    }
    QVERIFY(refined == (std::vector<Index>{20, 20, 5, 5, 11, 11}));
  }

  void refiningAgainMakesThemSmallerStill() {
    // Each time what the last refinement brought: whichever points there are, and with whatever room.
    for (const unsigned seed : {0U, 1U, 2U}) {
      Placed placed(test::cylinder(4.0, 0.5, 80, 40), 60, seed);
      placed.pose([&](const Vec3& place) { return test::bendAt(place, placed.mesh->bounds(), 120.0); });
      std::vector<Index> places = every(5, placed);
      for (int round = 0; round < 3; ++round) {
        const Refinement refinement = placed.refined(places, 2);
        // Some may have no room, but not all.
        QVERIFY(2 * refinement.points.size() >= places.size());
        QVERIFY(placed.changeBy(refinement) <= 0.005 + 1e-12);
        places.clear();
        for (const RefinedPoint& one : refinement.points) {
          QVERIFY(sizeOf(one.point.rest) < sizeOf(placed.set.finest()[one.refines].rest));
          places.push_back(placed.set.finest().size() + static_cast<Index>(places.size()));
        }
        for (const RefinedPoint& one : refinement.points) {
          placed.set.levels[0].append(one.point);
        }
      }
    }
  }

  void sameBitsOnAnyNumberOfThreads() {
    Placed placed(test::fork(), 60);
    placed.pose([&](const Vec3& place) { return test::bendAt(place, placed.mesh->bounds(), 120.0); });
    placed.cache = nullptr;
    const Refinement many = placed.refined(every(2, placed), 3);
    const ThreadLimit one(1);
    const Refinement alone = placed.refined(every(2, placed), 3);
    QCOMPARE(alone.points.size(), many.points.size());
    for (std::size_t i = 0; i < many.points.size(); ++i) {
      QVERIFY(alone.points[i].point == many.points[i].point);
    }
  }

  void refiningCanBeCancelledAtAnyStage() {
    Placed placed(test::fork(), 40);
    placed.pose([&](const Vec3& place) { return test::bendAt(place, placed.mesh->bounds(), 90.0); });
    for (const char* stage : {"Placing points: sites", "Refining: places", "Refining: poses"}) {
      Progress handle;
      const Progress progress([&](std::string_view reported, double) {
        if (reported == stage) {
          handle.cancel();
        }
      });
      handle = progress;
      QVERIFY_EXCEPTION_THROWN(refinedPoints(placed.mesh, placed.set, {1, 2, 3}, {placed.options, 2}, progress),
                               Cancelled);
    }
  }

  void meshWithoutFacesIsRefused() {
    Placed placed(test::sphere(), 20);
    Mesh cloud = test::sphere();
    cloud.faces = {};
    placed.mesh = std::make_shared<const RestMesh>(std::move(cloud));
    QVERIFY_EXCEPTION_THROWN(placed.refined({1}, 2), InvalidInput);
  }
};

const test::Registration<RefinementTest> registration;

}  // namespace pbffd

#include "refinement_test.moc"
