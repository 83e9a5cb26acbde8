#include "core/ffd/placement/dense_merging.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <random>

namespace pbffd {
namespace {

Points randomPoints(Index count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  Points points(count, 3);
  for (Index i = 0; i < count; ++i) {
    points.row(i) << share(random), share(random), share(random);
  }
  return points;
}

/// Many pairs are as close as others.
Points gridPoints() {
  Points points(125, 3);
  for (int i = 0; i < 125; ++i) {
    points.row(i) << i % 5, i / 5 % 5, i / 25;
  }
  return points;
}

void requireSameAsTheTree(const Points& points, Index target) {
  const MergedPoints dense = mergeFewClosestPairs(points, target);
  const MergedPoints tree = mergeClosestPairs(points, target);
  QVERIFY(dense.points == tree.points);
  QCOMPARE(dense.places, tree.places);
  QCOMPARE(dense.merges.size(), tree.merges.size());
  for (std::size_t i = 0; i < tree.merges.size(); ++i) {
    QCOMPARE(dense.merges[i].kept, tree.merges[i].kept);
    QCOMPARE(dense.merges[i].gone, tree.merges[i].gone);
  }
}

}  // namespace

class DenseMergingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void mergesAsTheTreeDoes() {
    for (const unsigned seed : {1U, 2U, 3U}) {
      requireSameAsTheTree(randomPoints(200, seed), 40);
    }
    requireSameAsTheTree(randomPoints(60, 4), 1);
  }

  void tiesGoAsInTheTree() { requireSameAsTheTree(gridPoints(), 20); }

  void samePointsMergeFirst() {
    Points points = randomPoints(50, 5);
    points.row(31) = points.row(7);
    const MergedPoints merged = mergeFewClosestPairs(points, 49);
    QCOMPARE(merged.merges.size(), std::size_t(1));
    QCOMPARE(merged.merges[0].kept, Index(7));
    QCOMPARE(merged.merges[0].gone, Index(31));
  }

  void nothingIsMergedBelowTheTarget() {
    QCOMPARE(mergeFewClosestPairs(randomPoints(5, 6), 9).places.size(), std::size_t(5));
    QCOMPARE(mergeFewClosestPairs(randomPoints(5, 6), 0).places.size(), std::size_t(1));
    QCOMPARE(mergeFewClosestPairs(Points(0, 3), 4).places.size(), std::size_t(0));
  }
};

const test::Registration<DenseMergingTest> registration;

}  // namespace pbffd

#include "dense_merging_test.moc"
