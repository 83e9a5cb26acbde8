#include "core/ffd/basis.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>

namespace pbffd {

class BasisTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void valueIsOneAtTheCentreAndZeroFromTheBorder() {
    for (const Basis& basis : kernels()) {
      QCOMPARE(basisValue(basis, 0.0), 1.0);
      QCOMPARE(basisValue(basis, 1.0), 0.0);
      QCOMPARE(basisValue(basis, 4.0), 0.0);
      QCOMPARE(basisSlope(basis, 1.0), 0.0);
      QCOMPARE(basisValue(basis, std::nan("")), 0.0);
      QVERIFY(basisValue(basis, 1.0 - 1e-12) >= 0.0);
    }
  }

  void valuesAreTheFormulas() {
    for (double u = 0.0; u < 1.0; u += 0.013) {
      const double square = u * u;
      QVERIFY(std::abs(basisValue({Kernel::smooth, 3.0}, square) - std::pow(1.0 - square, 3)) < 1e-15);
      const double wendland = std::pow(1.0 - u, 4) * (4.0 * u + 1.0);
      QVERIFY(std::abs(basisValue({Kernel::wendland, 3.0}, square) - wendland) < 1e-15);
    }
  }

  void gaussianAgreesWithTheSystemsExponential() {
    for (const double sigma : {0.5, 3.0, 10.0, 37.0}) {
      for (double square = 0.0; square < 1.0; square += 1.0 / 4099.0) {
        const double expected = std::exp(-0.5 * sigma * sigma * square);
        const double value = basisValue({Kernel::gaussian, sigma}, square);
        QVERIFY2(std::abs(value - expected) <= 1e-15 * expected, qPrintable(QString::number(square)));
      }
    }
    QCOMPARE(basisValue({Kernel::gaussian, 1e3}, 0.5), 0.0);
  }

  void slopeIsTheDerivative() {
    const double h = 1e-6;
    for (const Basis& basis : kernels()) {
      for (double square = 0.01; square < 0.98; square += 0.017) {
        const double numeric = (basisValue(basis, square + h) - basisValue(basis, square - h)) / (2.0 * h);
        QVERIFY(std::abs(basisSlope(basis, square) - numeric) < 1e-8);
      }
    }
  }

  void parameterIsOneAtTheEndsOfTheAxes() {
    const Frame frame = turnedFrame();
    const Region region(frame);
    for (int k = 0; k < 3; ++k) {
      const Vec3 u = region.parameter(frame.center + frame.axes.col(k));
      QVERIFY((u - Vec3::Unit(k)).norm() < 1e-14);
    }
    QCOMPARE(region.squaredDistance(frame.center), 0.0);
  }

  void turnedSphereIsASphere() {
    Frame frame = turnedFrame();
    const Vec3 place(1.3, 1.6, 3.4);
    QCOMPARE(Region(frame).inverseSquare, 0.0);
    for (Index k = 0; k < 3; ++k) {
      frame.axes.col(k) *= 0.7 / frame.axes.col(k).norm();
    }
    const Region turned(frame);
    const Region upright({frame.center, 0.7 * Mat3::Identity()});
    QVERIFY(std::abs(upright.inverseSquare - 1.0 / 0.49) < 1e-15);
    QVERIFY(std::abs(turned.inverseSquare - upright.inverseSquare) < 1e-14);
    QVERIFY(std::abs(turned.squaredDistance(place) - turned.parameter(place).squaredNorm()) < 1e-15);
    QVERIFY(std::abs(turned.squaredDistance(place) - upright.squaredDistance(place)) < 1e-15);
    frame.axes.col(1) *= 1.0 + 1e-12;
    QCOMPARE(Region(frame).inverseSquare, 0.0);
  }

  void halfSizesBoundTheEllipsoidTightly() {
    const Frame frame = turnedFrame();
    const Region region(frame);
    Vec3 reached = Vec3::Zero();
    for (double theta = 0.0; theta < 3.15; theta += 0.01) {
      for (double phi = 0.0; phi < 6.3; phi += 0.01) {
        const Vec3 u(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        reached = reached.cwiseMax((frame.axes * u).cwiseAbs());
      }
    }
    QVERIFY((reached.array() <= region.halfSizes().array() + 1e-12).all());
    QVERIFY((reached.array() >= 0.999 * region.halfSizes().array()).all());
  }

 private:
  static std::vector<Basis> kernels() {
    return {{Kernel::smooth, 3.0}, {Kernel::wendland, 3.0}, {Kernel::gaussian, 3.0}};
  }

  static Frame turnedFrame() {
    Mat3 turn;
    turn << 2, -1, 2, 2, 2, -1, -1, 2, 2;
    turn /= 3.0;
    return {Vec3(1, 2, 3), turn * Vec3(0.5, 1.0, 2.0).asDiagonal()};
  }
};

const test::Registration<BasisTest> registration;

}  // namespace pbffd

#include "basis_test.moc"
