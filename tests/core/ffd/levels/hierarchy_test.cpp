#include "core/ffd/levels/hierarchy.h"
#include "core/base/error.h"
#include "core/ffd/frame_checks.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

namespace pbffd {

class HierarchyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachLevelHasHalfAsMany_data() {
    QTest::addColumn<int>("points");
    QTest::addColumn<QList<int>>("sizes");
    QTest::newRow("even") << 200 << QList<int>{50, 100, 200};
    QTest::newRow("odd") << 197 << QList<int>{49, 98, 197};
    QTest::newRow("two") << 2 << QList<int>{1, 2};
    QTest::newRow("one") << 1 << QList<int>{1};
  }

  void eachLevelHasHalfAsMany() {
    QFETCH(int, points);
    QFETCH(QList<int>, sizes);
    PointId nextId = 1;
    const std::vector<Level> levels = buildLevels(randomLevel(points, nextId), 3, nextId);
    QCOMPARE(static_cast<int>(levels.size()), static_cast<int>(sizes.size()));
    for (std::size_t l = 0; l < levels.size(); ++l) {
      QCOMPARE(levels[l].size(), sizes[static_cast<int>(l)]);
    }
    QCOMPARE(greatestLevelCount(points) >= static_cast<int>(levels.size()), true);
  }

  void greatestLevelCountIsWhatHalvingAllows() {
    QCOMPARE(greatestLevelCount(0), 1);
    QCOMPARE(greatestLevelCount(1), 1);
    QCOMPARE(greatestLevelCount(3), 2);
    QCOMPARE(greatestLevelCount(200), 8);
  }

  void everyPointStandsForFinerOnesOnce() {
    PointId nextId = 1;
    const std::vector<Level> levels = buildLevels(randomLevel(200, nextId), 3, nextId);
    for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
      std::multiset<PointId> members;
      for (const ControlPoint& point : levels[l]) {
        QVERIFY(!point.mergedFrom.empty());
        QVERIFY(std::is_sorted(point.mergedFrom.begin(), point.mergedFrom.end()));
        QVERIFY(point.kind == PointKind::merged);
        QVERIFY(point.pose == point.rest);
        members.insert(point.mergedFrom.begin(), point.mergedFrom.end());
      }
      std::multiset<PointId> finer;
      for (const ControlPoint& point : levels[l + 1]) {
        finer.insert(point.id);
        QVERIFY(point.binding.at == point.rest.center);
        QVERIFY(point.binding.local == identityMap());
      }
      QVERIFY(members == finer);
    }
  }

  void identifiersAreNewAndUsedOnce() {
    PointId nextId = 1;
    const std::vector<Level> levels = buildLevels(randomLevel(90, nextId), 4, nextId);
    std::set<PointId> seen;
    Index count = 0;
    for (const Level& level : levels) {
      for (const ControlPoint& point : level) {
        seen.insert(point.id);
        QVERIFY(point.id < nextId);
        ++count;
      }
    }
    QCOMPARE(static_cast<Index>(seen.size()), count);
  }

  void closestPairMergesAtItsMidPointAndEnclosesBoth() {
    Level finer;
    finer.append(sphereAt(1, Vec3(0, 0, 0), 1.0));
    finer.append(sphereAt(2, Vec3(10, 0, 0), 2.0));
    finer.append(sphereAt(3, Vec3(11, 0, 0), 0.5));
    finer.append(sphereAt(4, Vec3(0, 20, 0), 1.0));
    PointId nextId = 5;
    const Level coarser = coarserLevel(finer, nextId);
    // 2 and 3 first; then their mid-point and 1 (distance 10.5).
    QCOMPARE(coarser.size(), 2);
    QVERIFY(coarser[0].mergedFrom == (std::vector<PointId>{1, 2, 3}));
    QVERIFY(coarser[1].mergedFrom == (std::vector<PointId>{4}));
    QVERIFY(coarser[0].rest.center == Vec3(5.25, 0, 0));
    QCOMPARE(coarser[0].rest.axes(0, 0), 0.5 * 10.5 + (0.5 + 2.0));
    QVERIFY(coarser[1].rest == finer[3].rest);
  }

  void mergedPointReachesAllOnlyWhereAllMembersDo() {
    Level finer;
    for (PointId id = 1; id <= 4; ++id) {
      ControlPoint point = sphereAt(id, Vec3(id <= 2 ? 0.0 : 9.0, 0.1 * id, 0), 1.0);
      point.reach = id == 4 ? Reach::connected : Reach::all;
      finer.append(point);
    }
    PointId nextId = 5;
    const Level coarser = coarserLevel(finer, nextId);
    QVERIFY(coarser[0].reach == Reach::all);
    QVERIFY(coarser[1].reach == Reach::connected);
  }

  void unmovedCoarserLevelsLeaveEveryBit() {
    ControlSet set = scene();
    const auto bindings = levelBindings(*mesh_, set);
    move(set, 2, 3, Vec3(0.1, 0.2, 0.3));
    rebind(set, 2, bindings);
    const ControlSet before = set;
    carryDown(before, set, 0, bindings);
    QVERIFY(set == before);
    for (Index i = 0; i < set.finest().size(); ++i) {
      QVERIFY(set.finest().shares(i, before.finest()));
    }
  }

  void oneMapOfALevelAndTheMasterCarriesEveryFinerLevel() {
    for (int level = 0; level < 3; ++level) {
      ControlSet set = scene();
      const auto bindings = levelBindings(*mesh_, set);
      // Detail on the finest level first, which has to go along.
      ControlSet before = set;
      move(set, 2, 5, Vec3(0.1, -0.2, 0.05));
      rebind(set, 2, bindings);
      before = set;
      const AffineMap map = makeMap(Mat3(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix() *
                                         Vec3(1.2, 0.8, 1.1).asDiagonal()),
                                    Vec3(3, -1, 2));
      for (Index i = 0; i < set.levels[level].size(); ++i) {
        ControlPoint point = set.levels[level][i];
        point.pose = moved(point.pose, map);
        set.levels[level].replace(i, point);
      }
      set.master.pose = moved(set.master.pose, map);
      for (int l = 1; l <= level; ++l) {
        rebind(set, l, bindings);
      }
      carryDown(before, set, level, bindings);
      for (std::size_t l = level; l < set.levels.size(); ++l) {
        for (Index i = 0; i < set.levels[l].size(); ++i) {
          const Frame expected = moved(before.levels[l][i].pose, map);
          QVERIFY(difference(set.levels[l][i].pose, expected) < 1e-12 * mesh_->diagonal());
        }
      }
    }
  }

  void reboundPosesAreWhatTheCoarserLevelGives() {
    ControlSet set = scene();
    const auto bindings = levelBindings(*mesh_, set);
    const ControlSet rest = set;
    for (Index i = 0; i < set.levels[0].size(); ++i) {
      move(set, 0, i, 0.05 * Vec3(std::sin(i), std::cos(i), std::sin(3.0 * i)));
    }
    carryDown(rest, set, 0, bindings);
    for (Index i = 0; i < set.levels[1].size(); i += 3) {
      move(set, 1, i, 0.02 * Vec3(std::sin(2.0 * i), std::cos(i), 1.0));
    }
    const Level asked = set.levels[1];
    rebind(set, 1, bindings);
    const LevelMaps maps = mapsOf(set, set.levels[0]);
    for (Index i = 0; i < set.levels[1].size(); ++i) {
      const ControlPoint& point = set.levels[1][i];
      QVERIFY(point.pose == asked[i].pose);
      const Frame given = moved(point.rest, composed(blendedMap(bindings[0], i, maps), point.binding.local));
      QVERIFY(difference(given, point.pose) < 1e-13);
    }
  }

  void rebindingTwiceChangesNothing() {
    ControlSet set = scene();
    const auto bindings = levelBindings(*mesh_, set);
    const ControlSet rest = set;
    move(set, 0, 0, Vec3(0.3, 0.1, 0.0));
    carryDown(rest, set, 0, bindings);
    move(set, 1, 2, Vec3(0.0, 0.1, 0.0));
    rebind(set, 1, bindings);
    const ControlSet once = set;
    rebind(set, 1, bindings);
    QVERIFY(set == once);
  }

  void bindingToAFlattenedLevelIsAnError() {
    ControlSet set = scene();
    const auto bindings = levelBindings(*mesh_, set);
    const AffineMap flat = makeMap(Mat3(Vec3(1, 1, 0).asDiagonal()), Vec3::Zero());
    for (Index i = 0; i < set.levels[0].size(); ++i) {
      ControlPoint point = set.levels[0][i];
      point.pose = moved(point.rest, flat);
      set.levels[0].replace(i, point);
    }
    set.master.pose = moved(set.master.rest, flat);
    QVERIFY_EXCEPTION_THROWN(rebind(set, 1, bindings), InvalidInput);
  }

  void fiveLevelsOverAThousandPointsAreQuick() {
    PointId nextId = 1;
    const Level finest = randomLevel(1000, nextId);
    QElapsedTimer timer;
    timer.start();
    const std::vector<Level> levels = buildLevels(finest, 5, nextId);
    const auto milliseconds = timer.elapsed();
    QCOMPARE(levels.front().size(), 62);
    qInfo("5 levels over 1,000 points: %lld ms", static_cast<long long>(milliseconds));
    // Ten times what it takes, for slow and busy machines.
    QVERIFY(milliseconds < 500);
  }

 private:
  static ControlPoint sphereAt(PointId id, const Vec3& center, double radius) {
    ControlPoint point;
    point.id = id;
    point.rest = {center, radius * Mat3::Identity()};
    point.pose = point.rest;
    return point;
  }

  static Level randomLevel(int count, PointId& nextId) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    Level level;
    for (int i = 0; i < count; ++i) {
      const double x = place(random);
      const double y = place(random);
      level.append(sphereAt(nextId++, Vec3(x, y, place(random)), 0.4));
    }
    return level;
  }

  ControlSet scene() const {
    ControlSet set;
    set.master.rest = {Vec3::Zero(), 3.0 * Mat3::Identity()};
    set.master.pose = set.master.rest;
    PointId nextId = 1;
    set.levels = buildLevels(randomLevel(40, nextId), 3, nextId);
    return set;
  }

  static void move(ControlSet& set, int level, Index place, const Vec3& by) {
    ControlPoint point = set.levels[level][place];
    point.pose.center += by;
    set.levels[level].replace(place, point);
  }

  static double difference(const Frame& a, const Frame& b) {
    return std::max((a.center - b.center).cwiseAbs().maxCoeff(), (a.axes - b.axes).cwiseAbs().maxCoeff());
  }

  std::shared_ptr<const RestMesh> mesh_ = std::make_shared<const RestMesh>(test::sphere());
};

const test::Registration<HierarchyTest> registration;

}  // namespace pbffd

#include "hierarchy_test.moc"
