#include "core/mesh/io/vertex_welder.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>

namespace pbffd::io {

class VertexWelderTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void manyPointsKeepTheirNumbers() {
    VertexWelder welder;
    const auto point = [](int i) { return Vec3(i % 20, (i / 20) % 20, 0.1 * (i / 400)); };
    for (int round = 0; round < 2; ++round) {
      for (int i = 0; i < 8000; ++i) {
        QCOMPARE(welder.add(point(i)), i);
      }
    }
    QCOMPARE(welder.size(), std::size_t{8000});
    QVERIFY(welder.points().row(7999) == point(7999).transpose());
  }

  void zeroAndMinusZeroAreTheSame() {
    VertexWelder welder;
    welder.add({-0.0, 1, 0});
    QCOMPARE(welder.add({0.0, 1, -0.0}), 0);
    QVERIFY(std::signbit(welder.points()(0, 0)));
    QCOMPARE(welder.add({5e-324, 1, 0}), 1);
  }
};

const test::Registration<VertexWelderTest> registration;

}  // namespace pbffd::io

#include "vertex_welder_test.moc"
