#include "core/ffd/weights/point_blocks.h"
#include "tests/core/ffd/scenes.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <bit>
#include <set>

namespace pbffd {

class PointBlocksTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void distancesHaveTheBitsOfTheRegions() {
    const test::Scene scene(test::sphere(30, 41));
    const PointBlocks blocks(scene.mesh->positions(), scene.mesh->mortonOrder());
    const Region region(scene.set.finest()[3].rest);
    for (Index slot = 0; slot < scene.mesh->vertexCount(); ++slot) {
      const Vec3 vertex = scene.mesh->positions().row(scene.mesh->mortonOrder()[slot]);
      QVERIFY(blocks.point(slot / 16, slot % 16) == vertex);
      const double squared = blocks.squaredDistances(slot / 16, region)[slot % 16];
      QCOMPARE(std::bit_cast<std::uint64_t>(squared),
               std::bit_cast<std::uint64_t>(region.squaredDistance(vertex)));
    }
  }

  void blocksNearHoldEveryPointOfTheRegion_data() {
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("shift");
    QTest::newRow("plain") << 1.0 << 0.0;
    QTest::newRow("far from the origin") << 1.0 << 1e8;
    QTest::newRow("tiny") << 1e-12 << 0.0;
    QTest::newRow("huge") << 1e12 << 0.0;
  }

  void blocksNearHoldEveryPointOfTheRegion() {
    QFETCH(double, scale);
    QFETCH(double, shift);
    const test::Scene scene(test::placedAt(test::sphere(60, 81), scale, Vec3::Constant(shift)), 60, 0.1);
    const PointBlocks blocks(scene.mesh->positions(), scene.mesh->mortonOrder());
    Index looked = 0;
    for (const ControlPoint& point : scene.set.finest()) {
      const Region region(point.rest);
      const std::vector<Index> near = blocks.blocksNear(region);
      looked += static_cast<Index>(near.size());
      QVERIFY(std::is_sorted(near.begin(), near.end()));
      for (Index slot = 0; slot < scene.mesh->vertexCount(); ++slot) {
        if (region.squaredDistance(scene.mesh->positions().row(scene.mesh->mortonOrder()[slot])) < 1.0) {
          QVERIFY(std::binary_search(near.begin(), near.end(), slot / 16));
        }
      }
    }
    QVERIFY(looked < blocks.blockCount() * scene.set.finest().size() / 5);
  }

  void wholeBlocksAreInside_data() { blocksNearHoldEveryPointOfTheRegion_data(); }

  void wholeBlocksAreInside() {
    QFETCH(double, scale);
    QFETCH(double, shift);
    // As many vertices as leave the last block in part empty.
    const test::Scene scene(test::placedAt(test::sphere(60, 81), scale, Vec3::Constant(shift)), 20, 0.4);
    const PointBlocks blocks(scene.mesh->positions(), scene.mesh->mortonOrder());
    QVERIFY(blocks.all(blocks.blockCount() - 1) != 0xffff);
    std::set<Index> whole;
    for (const ControlPoint& point : scene.set.finest()) {
      const Region region(point.rest);
      Index last = -1;
      blocks.forEachNear(region, [&](Index begin, Index end, bool isWhole) {
        QVERIFY(begin > last && end > begin && end <= blocks.blockCount());
        last = end - 1;
        for (Index block = begin; isWhole && block < end; ++block) {
          QCOMPARE(blocks.inside(block, region), blocks.all(block));
          whole.insert(block);
        }
      });
    }
    QVERIFY(static_cast<Index>(whole.size()) > blocks.blockCount() / 3);
  }

  void noPointsMakeNoBlocks() {
    const PointBlocks blocks(Points(0, 3), {});
    QCOMPARE(blocks.blockCount(), 0);
    QVERIFY(blocks.blocksNear(Region(Frame())).empty());
  }
};

const test::Registration<PointBlocksTest> registration;

}  // namespace pbffd

#include "point_blocks_test.moc"
