#include "core/ffd/placement/octree_cells.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

namespace pbffd {
namespace {

Points spiral(Index count) {
  Points points(count, 3);
  for (Index i = 0; i < count; ++i) {
    points.row(i) = Vec3(std::cos(0.1 * i), std::sin(0.1 * i), 0.001 * i);
  }
  return points;
}

}  // namespace

class OctreeCellsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyPointIsInOneCellOfNoMoreThanTheCapacity() {
    const OctreeCells cells = octreeCells(spiral(5000), {}, 64);
    std::vector<Index> order = cells.order;
    std::sort(order.begin(), order.end());
    for (Index i = 0; i < 5000; ++i) {
      QCOMPARE(order[static_cast<std::size_t>(i)], i);
    }
    QCOMPARE(cells.start.front(), 0);
    QCOMPARE(cells.start.back(), 5000);
    for (std::size_t c = 1; c < cells.start.size(); ++c) {
      const Index size = cells.start[c] - cells.start[c - 1];
      QVERIFY(size > 0 && size <= 64);
    }
  }

  void identicalPointsShareACell() {
    const OctreeCells cells = octreeCells(Points::Constant(500, 3, 2.0), {}, 64);
    QCOMPARE(cells.start, (std::vector<Index>{0, 500}));
  }

  void groupsShareNoCell() {
    std::vector<Index> groups;
    for (Index i = 0; i < 1000; ++i) {
      groups.push_back(i % 2);
    }
    const OctreeCells cells = octreeCells(spiral(1000), groups, 2000);
    QCOMPARE(cells.start, (std::vector<Index>{0, 500, 1000}));
    for (std::size_t i = 0; i < 1000; ++i) {
      QCOMPARE(cells.order[i] % 2, i < 500 ? 0 : 1);
    }
  }

  void noPointsHaveNoCells() {
    const OctreeCells cells = octreeCells(Points(0, 3), {});
    QCOMPARE(cells.start, (std::vector<Index>{0}));
  }
};

const test::Registration<OctreeCellsTest> registration;

}  // namespace pbffd

#include "octree_cells_test.moc"
