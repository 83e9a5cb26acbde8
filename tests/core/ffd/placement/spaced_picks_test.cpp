#include "core/ffd/placement/spaced_picks.h"
#include "core/ffd/placement/random_order.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <vector>

namespace pbffd {

class SpacedPicksTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nothingNearerThanTheSpacingIsPicked() {
    SpacedPicks picks(Vec3::Zero(), Vec3::Ones(), 0.1);
    std::vector<Vec3> picked;
    for (std::uint64_t i = 0; i < 20000; ++i) {
      const Vec3 at(randomShare(1, 3 * i), randomShare(1, 3 * i + 1), randomShare(1, 3 * i + 2));
      bool hasRoom = true;
      for (const Vec3& other : picked) {
        hasRoom = hasRoom && (other - at).squaredNorm() >= 0.1 * 0.1;
      }
      QCOMPARE(picks.pick({at, Vec3::Zero(), 0, 0.1}), hasRoom);
      if (hasRoom) {
        picked.push_back(at);
      }
    }
    QCOMPARE(picks.size(), static_cast<Index>(picked.size()));
    QVERIFY(picks.size() > 400);
  }

  void otherPartsAndOtherSidesDoNotCount() {
    SpacedPicks picks(Vec3::Zero(), Vec3::Ones(), 0.5);
    QVERIFY(picks.pick({Vec3(0.5, 0.5, 0.5), Vec3::UnitX(), 0, 0.5}));
    QVERIFY(!picks.pick({Vec3(0.5, 0.5, 0.6), Vec3::UnitX(), 0, 0.5}));
    QVERIFY(picks.pick({Vec3(0.5, 0.5, 0.6), -Vec3::UnitX(), 0, 0.5}));
    QVERIFY(picks.pick({Vec3(0.5, 0.5, 0.6), Vec3::UnitX(), 1, 0.5}));
  }

  void lesserSpacingRules() {
    SpacedPicks picks(Vec3::Zero(), Vec3::Ones(), 0.5);
    QVERIFY(picks.pick({Vec3(0.5, 0.5, 0.5), Vec3::Zero(), 0, 0.5}));
    QVERIFY(picks.pick({Vec3(0.5, 0.5, 0.6), Vec3::Zero(), 0, 0.05}));
    QVERIFY(!picks.pick({Vec3(0.5, 0.5, 0.61), Vec3::Zero(), 0, 0.5}));
  }

  void randomOrderVisitsEachOnce() {
    for (const std::uint64_t count : {0, 1, 2, 3, 10, 144, 1000}) {
      const RandomOrder order(count, 3);
      std::vector<int> visits(count, 0);
      for (std::uint64_t i = 0; i < count; ++i) {
        ++visits[order[i]];
      }
      QCOMPARE(visits, std::vector<int>(count, 1));
    }
  }
};

const test::Registration<SpacedPicksTest> registration;

}  // namespace pbffd

#include "spaced_picks_test.moc"
