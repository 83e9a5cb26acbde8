#include "core/ffd/control_point.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <QtTest>

namespace pbffd {

class ControlPointTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void mapAtRestIsTheIdentityToTheLastBit() { QVERIFY(mapBetween(oddFrame(), oddFrame()) == identityMap()); }

  void mapOfAMovedCentreIsATranslationExactly() {
    Frame pose = oddFrame();
    pose.center += Vec3(0.1, 0.2, 0.3);
    const AffineMap map = mapBetween(oddFrame(), pose);
    QVERIFY(map.leftCols<3>() == Mat3::Identity());
    QVERIFY(map.col(3) == pose.center - oddFrame().center);
  }

  void mapCarriesRestToPose() {
    Frame pose;
    pose.center = Vec3(-3, 0.5, 7);
    pose.axes << 1, 0.2, 0, 0.3, 2, 0.1, 0, 0.4, 0.5;
    const Frame carried = moved(oddFrame(), mapBetween(oddFrame(), pose));
    QVERIFY((carried.center - pose.center).norm() < 1e-14);
    QVERIFY((carried.axes - pose.axes).norm() < 1e-14);
  }

  void identityMovesNoBit() { QVERIFY(moved(oddFrame(), identityMap()) == oddFrame()); }

 private:
  static Frame oddFrame() {
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    return {Vec3(0.1, -0.7, 1.0 / 3.0), turn * Vec3(0.3, 0.7, 1.1).asDiagonal()};
  }
};

const test::Registration<ControlPointTest> registration;

}  // namespace pbffd

#include "control_point_test.moc"
