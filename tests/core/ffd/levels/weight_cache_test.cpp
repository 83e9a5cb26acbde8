#include "core/ffd/levels/weight_cache.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <functional>

namespace pbffd {

class WeightCacheTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void posesAndNamesFindTheSameWeights() {
    WeightCache cache;
    test::Scene scene(test::sphere());
    const auto first = cache.parameterization(scene.mesh, scene.set);
    scene.poseAtRandom(0.1, true);
    change(scene.set, 3, [](ControlPoint& point) {
      point.name = "elbow";
      point.locked = true;
    });
    QCOMPARE(cache.parameterization(scene.mesh, scene.set), first);
  }

  void whatWeightsFollowFromMakesOthers() {
    const test::Scene scene(test::sphere());
    using Change = std::function<void(ControlSet&)>;
    const std::vector<Change> changes = {
        [](ControlSet& set) { set.basis.kernel = Kernel::gaussian; },
        [](ControlSet& set) { set.master.value = 0.5; },
        [](ControlSet& set) { set.master.mode = MasterMode::paper; },
        [](ControlSet& set) { change(set, 2, [](ControlPoint& point) { point.enabled = false; }); },
        [](ControlSet& set) { change(set, 2, [](ControlPoint& point) { point.strength *= 2.0; }); },
        [](ControlSet& set) { change(set, 2, [](ControlPoint& point) { point.rest.center.x() += 0.01; }); },
        [](ControlSet& set) { change(set, 3, [](ControlPoint& point) { point.reach = Reach::connected; }); },
        [](ControlSet& set) { set.levels[0].remove(0); },
    };
    WeightCache cache;
    const auto plain = cache.parameterization(scene.mesh, scene.set);
    for (const Change& apply : changes) {
      ControlSet changed = scene.set;
      apply(changed);
      const auto other = cache.parameterization(scene.mesh, changed);
      QVERIFY(other != plain);
      const Parameterization afresh =
          parameterize(*scene.mesh, changed.basis, changed.master, changed.finest());
      QVERIFY(other->weights == afresh.weights && other->points == afresh.points);
      QCOMPARE(cache.parameterization(scene.mesh, scene.set), plain);
    }
  }

  void equalValuesOfOtherObjectsAreFound() {
    WeightCache cache;
    const test::Scene scene(test::sphere());
    ControlSet copy = scene.set;
    change(copy, 4, [](ControlPoint&) {});
    QCOMPARE(cache.parameterization(scene.mesh, copy), cache.parameterization(scene.mesh, scene.set));
  }

  void anotherMeshHasWeightsOfItsOwn() {
    WeightCache cache;
    const test::Scene scene(test::sphere());
    const auto twin = std::make_shared<const RestMesh>(Mesh(scene.mesh->mesh()));
    QVERIFY(cache.parameterization(twin, scene.set) != cache.parameterization(scene.mesh, scene.set));
  }

  void aMeshIsNotKeptAlive() {
    WeightCache cache;
    std::weak_ptr<const RestMesh> watched;
    {
      const test::Scene scene(test::sphere());
      watched = scene.mesh;
      cache.parameterization(scene.mesh, scene.set);
    }
    QVERIFY(watched.expired());
  }

  void theLeastRecentlyUsedGoesFirst() {
    WeightCache cache;
    test::Scene scene(test::sphere());
    const auto first = cache.parameterization(scene.mesh, scene.set);
    const auto withMaster = [&](double value) {
      ControlSet set = scene.set;
      set.master.value = value;
      return cache.parameterization(scene.mesh, set);
    };
    const auto second = withMaster(1.0);
    withMaster(2.0);
    withMaster(3.0);
    QCOMPARE(cache.parameterization(scene.mesh, scene.set), first);
    withMaster(4.0);
    QCOMPARE(cache.parameterization(scene.mesh, scene.set), first);
    QVERIFY(withMaster(1.0) != second);
  }

  void bindingsFollowRegionsAndPlacesOfLevels() {
    WeightCache cache;
    test::Scene scene(test::sphere());
    PointId next = 1000;
    scene.set.levels = buildLevels(scene.set.finest(), 3, next);
    const auto first = cache.bindings(scene.mesh, scene.set);
    QCOMPARE(first->size(), std::size_t{2});
    ControlSet posed = scene.set;
    change(
        posed, 1, [](ControlPoint& point) { point.pose.center.x() += 1.0; }, 1);
    change(
        posed, 1, [](ControlPoint& point) { point.rest.axes *= 2.0; }, 2);
    QCOMPARE(cache.bindings(scene.mesh, posed), first);
    ControlSet rebound = scene.set;
    change(
        rebound, 1, [](ControlPoint& point) { point.binding.at.x() += 0.1; }, 2);
    QVERIFY(cache.bindings(scene.mesh, rebound) != first);
    ControlSet coarser = scene.set;
    change(
        coarser, 1, [](ControlPoint& point) { point.rest.axes *= 2.0; }, 0);
    QVERIFY(cache.bindings(scene.mesh, coarser) != first);
    QCOMPARE(cache.bindings(scene.mesh, scene.set), first);
  }

  void manyThreadsGetEqualWeights() {
    WeightCache cache;
    const test::Scene scene(test::sphere());
    std::vector<std::shared_ptr<const Parameterization>> found(64);
    parallelFor(found.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        found[i] = cache.parameterization(scene.mesh, scene.set);
      }
    });
    for (const auto& each : found) {
      QVERIFY(each->weights == found[0]->weights);
    }
  }

  void aCancelledComputationIsNotKept() {
    WeightCache cache;
    const test::Scene scene(test::sphere());
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(cache.parameterization(scene.mesh, scene.set, progress), Cancelled);
    QVERIFY(cache.parameterization(scene.mesh, scene.set) != nullptr);
  }

 private:
  static void change(ControlSet& set, Index place, const std::function<void(ControlPoint&)>& edit,
                     std::size_t level = 0) {
    ControlPoint point = set.levels[level][place];
    edit(point);
    set.levels[level].replace(place, point);
  }
};

const test::Registration<WeightCacheTest> registration;

}  // namespace pbffd

#include "weight_cache_test.moc"
