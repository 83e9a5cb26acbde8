#include "core/mesh/nearest.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>

namespace pbffd {

class NearestTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void agreesWithALinearSearch() {
    const Points points = Points::Random(500, 3);
    const NearestPoints tree(points);
    for (int q = 0; q < 50; ++q) {
      const Vec3 query = Vec3::Random();
      Eigen::Index expected = 0;
      const double distance =
          std::sqrt((points.rowwise() - query.transpose()).rowwise().squaredNorm().minCoeff(&expected));
      const auto found = tree.nearest(query);
      QCOMPARE(found.index, static_cast<Index>(expected));
      QVERIFY(std::abs(found.distance - distance) < 1e-14);
    }
  }

  void tiesGoToTheLowestIndex() {
    Points points(40, 3);
    for (int i = 0; i < 40; ++i) {
      points.row(i) = Vec3(i % 2 == 0 ? 1.0 : -1.0, 0, 0);
    }
    const NearestPoints tree(points);
    QCOMPARE(tree.nearest(Vec3::Zero()).index, 0);
    const auto three = tree.nearest(Vec3::Zero(), 3);
    QCOMPARE(three[0].index, 0);
    QCOMPARE(three[1].index, 1);
    QCOMPARE(three[2].index, 2);
  }

  void radiusIncludesItsBorder() {
    Points points(3, 3);
    points << 0, 0, 0, 1, 0, 0, 2, 0, 0;
    const NearestPoints tree(points);
    QCOMPARE(tree.within(Vec3::Zero(), 1.0).size(), std::size_t(2));
  }

  void moreAskedForThanThereAre() {
    const NearestPoints tree(Points::Random(3, 3));
    QCOMPARE(tree.nearest(Vec3::Zero(), 10).size(), std::size_t(3));
  }

  void noPointsGiveNoNeighbour() {
    const NearestPoints tree(Points(0, 3));
    QCOMPARE(tree.nearest(Vec3::Zero()).index, -1);
    QVERIFY(tree.nearest(Vec3::Zero(), 4).empty());
    QVERIFY(tree.within(Vec3::Zero(), 1.0).empty());
  }
};

const test::Registration<NearestTest> registration;

}  // namespace pbffd

#include "nearest_test.moc"
