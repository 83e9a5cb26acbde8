#include "ui/models/influence.h"

#include "core/ffd/levels/hierarchy.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <numeric>

namespace pbffd::test {

using ui::Influence;

/// Points along a bar, a region each.
ControlSet pointsAlongBar(int count, double radius) {
  ControlSet set;
  set.master.value = 0.01;
  for (int i = 0; i < count; ++i) {
    ControlPoint point;
    point.id = i + 1;
    point.rest.center = Vec3(4.0 * i / (count - 1), 0, 0);
    point.rest.axes *= radius;
    point.pose = point.rest;
    point.reach = Reach::all;
    set.levels[0].append(point);
  }
  return set;
}

class InfluenceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void countsAgreeWithTheReachedVertices();
  void allPointsReachAllThatAnyReaches();
  void thePointsOfACoarserLevelReachPoints();
  void noSelectionReachesNothing();
};

void InfluenceTest::countsAgreeWithTheReachedVertices() {
  const RestMesh mesh(cylinder());
  const ControlSet set = pointsAlongBar(5, 1.0);
  const Parameterization weights = parameterize(mesh, set.basis, set.master, set.finest());
  const Influence influence = ui::influenceOnMesh(weights, set.finest(), {3});
  QCOMPARE(influence.reached, static_cast<Index>(reachedVertices(mesh, set.finest()[2]).vertices.size()));
  QCOMPARE(influence.total, mesh.vertexCount());
  QCOMPARE(std::accumulate(influence.histogram.begin(), influence.histogram.end(), 0), influence.reached);
  QCOMPARE(influence.strongestPoint, PointId{3});
  QVERIFY(influence.strongest > 0.5 && influence.strongest < 1.0);
}

void InfluenceTest::allPointsReachAllThatAnyReaches() {
  const RestMesh mesh(cylinder());
  const ControlSet set = pointsAlongBar(5, 1.5);
  const Parameterization weights = parameterize(mesh, set.basis, set.master, set.finest());
  const Influence influence = ui::influenceOnMesh(weights, set.finest(), {1, 2, 3, 4, 5});
  QCOMPARE(influence.reached, mesh.vertexCount());
  // What the master leaves: almost everything.
  QVERIFY(influence.histogram.back() > mesh.vertexCount() / 2);
}

void InfluenceTest::thePointsOfACoarserLevelReachPoints() {
  const RestMesh mesh(cylinder());
  ControlSet set = pointsAlongBar(8, 1.0);
  PointId next = 9;
  set.levels = buildLevels(set.finest(), 2, next);
  const auto bindings = levelBindings(mesh, set);
  std::vector<PointId> all;
  for (const ControlPoint& point : set.levels[0]) {
    all.push_back(point.id);
  }
  const Influence influence = ui::influenceOnPoints(bindings[0], set.levels[0], all);
  QCOMPARE(influence.total, 8);
  QCOMPARE(influence.reached, 8);
}

void InfluenceTest::noSelectionReachesNothing() {
  const RestMesh mesh(cylinder());
  const ControlSet set = pointsAlongBar(5, 1.0);
  const Parameterization weights = parameterize(mesh, set.basis, set.master, set.finest());
  const Influence influence = ui::influenceOnMesh(weights, set.finest(), {});
  QCOMPARE(influence.reached, 0);
  QCOMPARE(influence.strongestPoint, PointId{0});
}

const Registration<InfluenceTest> registration;

}  // namespace pbffd::test

#include "influence_test.moc"
