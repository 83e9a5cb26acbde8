#include "core/ffd/placement/decimation.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/ffd/placement/dense_merging.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <random>

namespace pbffd {
namespace {

Points randomPoints(Index count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  return Points::NullaryExpr(count, 3, [&](Eigen::Index, Eigen::Index) { return share(random); });
}

/// Points on a grid: many distances are the same.
Points gridPoints(Index side) {
  Points points(side * side * side, 3);
  for (Index i = 0; i < points.rows(); ++i) {
    points.row(i) = Vec3(i % side, i / side % side, i / side / side);
  }
  return points;
}

/// All pairs are looked at for each merge.
MergedPoints naive(Points points, Index target, const MergeRules& rules = {}) {
  std::vector<bool> alive(static_cast<std::size_t>(points.rows()), true);
  auto left = static_cast<Index>(points.rows());
  MergedPoints result;
  while (left > target) {
    double best = std::numeric_limits<double>::infinity();
    Merge merge{-1, -1};
    for (Index i = 0; i < points.rows(); ++i) {
      for (Index j = i + 1; alive[i] && j < points.rows(); ++j) {
        if (!alive[j] || (!rules.groups.empty() && rules.groups[i] != rules.groups[j])) {
          continue;
        }
        double cost = (points.row(i) - points.row(j)).squaredNorm();
        cost *= rules.factor ? rules.factor(points.row(i), points.row(j)) : 1.0;
        if (cost < best) {
          best = cost;
          merge = {i, j};
        }
      }
    }
    if (merge.kept < 0) {
      break;
    }
    points.row(merge.kept) = 0.5 * (points.row(merge.kept) + points.row(merge.gone)).eval();
    alive[merge.gone] = false;
    result.merges.push_back(merge);
    --left;
  }
  result.points.resize(left, 3);
  for (Index i = 0; i < points.rows(); ++i) {
    if (alive[i]) {
      result.points.row(static_cast<Index>(result.places.size())) = points.row(i);
      result.places.push_back(i);
    }
  }
  return result;
}

bool areSame(const MergedPoints& a, const MergedPoints& b) {
  if (a.places != b.places || a.points != b.points || a.merges.size() != b.merges.size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.merges.size(); ++i) {
    if (a.merges[i].kept != b.merges[i].kept || a.merges[i].gone != b.merges[i].gone) {
      return false;
    }
  }
  return true;
}

}  // namespace

class DecimationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void mergesAsTheNaiveWay() {
    for (const Index count : {2, 9, 50, 300}) {
      for (const Index target : {1, count / 3, count - 1}) {
        const Points points = randomPoints(count, static_cast<unsigned>(count));
        QVERIFY(areSame(mergeClosestPairs(points, target), naive(points, target)));
      }
    }
  }

  void mergesThreeThousandAsTheNaiveWay() {
    const Points points = randomPoints(3000);
    // The naive way takes minutes down to few points; the first merges are those of the densest part ...
    QVERIFY(areSame(mergeClosestPairs(points, 2950), naive(points, 2950)));
    // ... and all the others are those of keeping each point's nearest, which dense_merging_test tries out.
    QVERIFY(areSame(mergeClosestPairs(points, 1), mergeFewClosestPairs(points, 1)));
  }

  void tiesGoToTheLowestPlaces() {
    const Points points = gridPoints(6);
    QVERIFY(areSame(mergeClosestPairs(points, 20), naive(points, 20)));
  }

  void identicalPointsBecomeOne() {
    const Points points = Points::Constant(500, 3, 0.7);
    const MergedPoints merged = mergeClosestPairs(points, 1);
    QVERIFY(areSame(merged, naive(points, 1)));
    QVERIFY(merged.points.row(0) == points.row(0));
  }

  void groupsStayApart() {
    const Points points = randomPoints(200);
    MergeRules rules;
    for (Index i = 0; i < 200; ++i) {
      rules.groups.push_back(i % 3);
    }
    QVERIFY(areSame(mergeClosestPairs(points, 20, rules), naive(points, 20, rules)));
    const MergedPoints least = mergeClosestPairs(points, 1, rules);
    QCOMPARE(least.points.rows(), Eigen::Index(3));
    QCOMPARE(least.places, (std::vector<Index>{0, 1, 2}));
  }

  void factorPutsPairsBackOrForbidsThem() {
    const Points points = randomPoints(200);
    MergeRules rules;
    rules.factor = [](const Vec3& a, const Vec3& b) { return a.x() * b.x() < 0.0 ? 9.0 : 1.0; };
    QVERIFY(areSame(mergeClosestPairs(points, 10, rules), naive(points, 10, rules)));
    rules.factor = [](const Vec3& a, const Vec3& b) {
      return a.x() * b.x() < 0.0 ? std::numeric_limits<double>::infinity() : 1.0;
    };
    QVERIFY(areSame(mergeClosestPairs(points, 1, rules), naive(points, 1, rules)));
    QCOMPARE(mergeClosestPairs(points, 1, rules).points.rows(), Eigen::Index(2));
  }

  void whoMayMergeWithNobodyIsAskedAboutFew() {
    // With more parts than points no pair may be left, however many there are.
    const Points points = randomPoints(2000);
    Index asked = 0;
    const MergeRules none{{}, [&](const Vec3&, const Vec3&) {
                            ++asked;
                            return std::numeric_limits<double>::infinity();
                          }};
    QCOMPARE(mergeClosestPairs(points, 100, none).points.rows(), 2000);
    QVERIFY(asked < 100 * 2000);
  }

  void mergesTellTheMidPoints() {
    Points points(3, 3);
    points << 0, 0, 0, 1, 0, 0, 5, 0, 0;
    const MergedPoints merged = mergeClosestPairs(points, 2);
    QCOMPARE(merged.merges.size(), std::size_t(1));
    QCOMPARE(merged.merges[0].kept, 0);
    QCOMPARE(merged.merges[0].gone, 1);
    QCOMPARE(merged.points(0, 0), 0.5);
    QCOMPARE(merged.places, (std::vector<Index>{0, 2}));
  }

  void octreeComesNearTheTargetAndKeepsTheSpread() {
    const Points points = randomPoints(40000);
    const Decimated decimated = decimateInOctree(points, 2000);
    QVERIFY(decimated.points.rows() <= 2000);
    QVERIFY(decimated.points.rows() > 1600);
    QVERIFY((decimated.points.colwise().minCoeff().array() < -0.8).all());
    QVERIFY((decimated.points.colwise().maxCoeff().array() > 0.8).all());
  }

  void octreeKeepsGroups() {
    const Points points = randomPoints(5000);
    MergeRules rules;
    for (Index i = 0; i < 5000; ++i) {
      rules.groups.push_back(i < 3 ? i : 7);
    }
    const Decimated decimated = decimateInOctree(points, 500, rules);
    QCOMPARE(decimated.groups.size(), static_cast<std::size_t>(decimated.points.rows()));
    for (const Index group : {0, 1, 2, 7}) {
      QVERIFY(std::count(decimated.groups.begin(), decimated.groups.end(), group) > 0);
    }
  }

  void octreeLeavesSmallSetsAlone() {
    const Points points = randomPoints(2000);
    QVERIFY(decimateInOctree(points, 2000).points == points);
  }

  void pointsInOnePlaceReachTheTarget() {
    QVERIFY(decimateInOctree(Points::Constant(50000, 3, 1.0), 10).points.rows() <= 10);
  }

  void threadsDoNotMatter() {
    const Points points = randomPoints(30000);
    const Decimated parallel = decimateInOctree(points, 1000);
    const ThreadLimit one(1);
    QVERIFY(decimateInOctree(points, 1000).points == parallel.points);
    QVERIFY(mergeClosestPairs(parallel.points, 50).points ==
            mergeClosestPairs(decimateInOctree(points, 1000).points, 50).points);
  }

  void cancelStopsIt() {
    const Progress progress([](std::string_view, double) {});
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(mergeClosestPairs(randomPoints(1000), 10, {}, progress), Cancelled);
    QVERIFY_EXCEPTION_THROWN(decimateInOctree(randomPoints(5000), 10, {}, progress), Cancelled);
  }
};

const test::Registration<DecimationTest> registration;

}  // namespace pbffd

#include "decimation_test.moc"
