#include "core/project/mirror.h"
#include "tests/core/project/projects.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class MirrorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void partnersAreMutualNearestWithinATenthOfTheRegion() {
    // 0 and 1 are partners; 2 lies on the plane; 3's image is nearest to 1, which has a nearer one; 4 is near
    // the plane but for more than a tenth of its region.
    const Level level =
        levelOf({Vec3(1, 0, 0), Vec3(-1.04, 0, 0), Vec3(0.02, 3, 0), Vec3(1.09, 0, 0), Vec3(0.08, 6, 0)});
    QVERIFY(mirrorPartners(level, Axis::x, Vec3::Zero()) == (std::vector<Index>{1, 0, 2, -1, -1}));
  }

  void planesMayLieElsewhere() {
    const Level level = levelOf({Vec3(0, 4, 0), Vec3(0, 6, 0)});
    QVERIFY(mirrorPartners(level, Axis::y, Vec3(9, 5, 9)) == (std::vector<Index>{1, 0}));
    QVERIFY(mirrorPartners(level, Axis::y, Vec3::Zero()) == (std::vector<Index>{-1, -1}));
  }

  void noPointsHaveNoPartners() { QVERIFY(mirrorPartners(Level(), Axis::z, Vec3::Zero()).empty()); }

  void reflectionIsItsOwnInverse() {
    const AffineMap mirror = reflection(Axis::z, Vec3(1, 2, 3));
    QVERIFY(composed(mirror, mirror) == identityMap());
    QVERIFY(applyMap(mirror, Vec3(4, 5, 6)) == Vec3(4, 5, 0));
  }

  void planeOfAnEditIsTheMiddleOfTheBoundsUnlessGiven() {
    const Project project = test::projectWith(4, 1, test::placedAt(test::sphere(), 1.0, Vec3(7, 0, 0)));
    Spread spread;
    QVERIFY((mirrorCenter(project, spread) - Vec3(7, 0, 0)).norm() < 1e-2);
    spread.hasPlane = true;
    spread.plane = Vec3(1, 2, 3);
    QVERIFY(mirrorCenter(project, spread) == Vec3(1, 2, 3));
  }

 private:
  static Level levelOf(const std::vector<Vec3>& centres) {
    Level level;
    for (const Vec3& center : centres) {
      ControlPoint point;
      point.id = level.size() + 1;
      point.rest = {center, 0.5 * Mat3::Identity()};
      point.pose = point.rest;
      level.append(point);
    }
    return level;
  }
};

const test::Registration<MirrorTest> registration;

}  // namespace pbffd

#include "mirror_test.moc"
