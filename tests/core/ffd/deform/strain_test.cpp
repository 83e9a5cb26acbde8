#include "core/ffd/deform/strain.h"
#include "tests/support/test_main.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QtTest>

namespace pbffd {

class StrainTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void stretchesAreThoseOfTheAxes() {
    const Strain strain = strainOf(turn() * Vec3(0.5, 3, 2).asDiagonal() * turn().transpose());
    QVERIFY((strain.stretches - Vec3(3, 2, 0.5)).norm() < 1e-14);
    QVERIFY(std::abs(strain.volume - 3.0) < 1e-14);
    QVERIFY(strainOf(Vec3(1, 1, -1).asDiagonal().toDenseMatrix()).volume < 0.0);
  }

  void normalStaysAtRightAnglesToTheTangents() {
    Mat3 gradient;
    gradient << 1, 0.3, -0.2, 0.1, 2, 0.5, 0, 0.7, 0.4;
    const Vec3 normal = carriedNormal(gradient, Vec3::UnitZ());
    QVERIFY(std::abs(normal.norm() - 1.0) < 1e-15);
    QVERIFY(std::abs(normal.dot(carriedTangent(gradient, Vec3::UnitX()))) < 1e-15);
    QVERIFY(std::abs(normal.dot(carriedTangent(gradient, Vec3::UnitY()))) < 1e-15);
  }

  void normalOfAFlattenedSpaceIsThatOfItsPlane() {
    QVERIFY(carriedNormal(Vec3(1, 1, 0).asDiagonal(), Vec3::UnitZ()) == Vec3::UnitZ());
    QVERIFY(carriedNormal(Vec3(1, 0, 0).asDiagonal(), Vec3::UnitZ()) == Vec3::Zero());
  }

  void rotationIsTheNearest() {
    QVERIFY((carriedRotation(turn() * Vec3(0.5, 3, 2).asDiagonal()) - turn()).norm() < 1e-14);
    QVERIFY(std::abs(carriedRotation(Vec3(1, 2, -0.1).asDiagonal()).determinant() - 1.0) < 1e-14);
  }

 private:
  static Mat3 turn() { return Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()).toRotationMatrix(); }
};

const test::Registration<StrainTest> registration;

}  // namespace pbffd

#include "strain_test.moc"
