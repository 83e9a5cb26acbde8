#include "core/ffd/control_set.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class ControlSetTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void findGivesThePlaceOfAnIdentifier() {
    const Level level = threePoints();
    QCOMPARE(level.find(7).value(), 1);
    QVERIFY(!level.find(8).has_value());
    QVERIFY(!Level().find(1).has_value());
  }

  void copiesShareWhatDidNotChange() {
    const Level before = threePoints();
    Level after = before;
    ControlPoint changed = after[1];
    changed.name = "elbow";
    after.replace(1, changed);
    QVERIFY(after.shares(0, before) && !after.shares(1, before) && after.shares(2, before));
    QVERIFY(!(after == before));
    changed.name = before[1].name;
    after.replace(1, changed);
    QVERIFY(after == before);
    after.remove(2);
    QVERIFY(!(after == before));
  }

  void mapsOfUnmovedPointsAreExactIdentities() {
    ControlSet set;
    set.levels[0] = threePoints();
    set.master.pose.center.x() = 2.0;
    ControlPoint moved = set.levels[0][2];
    moved.pose.center.y() += 1.0;
    set.levels[0].replace(2, moved);
    const LevelMaps maps = mapsOf(set, set.finest());
    QCOMPARE(maps.points.size(), std::size_t{3});
    QVERIFY(maps.points[0] == identityMap() && maps.points[1] == identityMap());
    QVERIFY(maps.points[2].col(3) == Vec3::UnitY());
    QVERIFY(maps.master.col(3) == Vec3(2, 0, 0));
  }

 private:
  static Level threePoints() {
    Level level;
    for (const PointId id : {3, 7, 5}) {
      ControlPoint point;
      point.id = id;
      level.append(point);
    }
    return level;
  }
};

const test::Registration<ControlSetTest> registration;

}  // namespace pbffd

#include "control_set_test.moc"
