#include "tests/quality/solids.h"
#include "core/mesh/rest_mesh.h"
#include "tests/quality/measures.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace pbffd {

/// The solids of the deformation tasks.
class SolidsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void solidsAreClosedAndFaceOutwards_data() {
    QTest::addColumn<int>("index");
    QTest::addColumn<int>("vertices");
    QTest::addColumn<double>("volume");
    const test::CactusSize size;
    const double trunk = std::numbers::pi * 0.25 * size.length;
    const double branch = std::numbers::pi * 0.0625 * (size.reach - size.radius);
    QTest::newRow("square bar") << 0 << 6194 << 6.0;
    QTest::newRow("cactus") << 1 << 4760 << trunk + branch;
  }
  void solidsAreClosedAndFaceOutwards() {
    QFETCH(int, index);
    QFETCH(int, vertices);
    QFETCH(double, volume);
    const RestMesh mesh(index == 0 ? test::squareBar({}) : test::cactus({}));
    QCOMPARE(static_cast<int>(mesh.positions().rows()), vertices);
    QCOMPARE(openEdges(mesh.triangles()), 0);
    const double measured = test::volume(mesh.positions(), mesh.triangles());
    QVERIFY(std::abs(measured - volume) < 0.02 * volume);
  }

 private:
  /// Edges that are not walked once in each direction.
  static int openEdges(const Triangles& triangles) {
    std::map<std::pair<Index, Index>, int> walked;
    for (Index t = 0; t < triangles.size(); ++t) {
      for (int c = 0; c < 3; ++c) {
        const Index from = triangles.vertices()[3 * t + c];
        const Index to = triangles.vertices()[3 * t + (c + 1) % 3];
        walked[std::minmax(from, to)] += from < to ? 1 : -1;
      }
    }
    int open = 0;
    for (const auto& [edge, balance] : walked) {
      open += balance != 0;
    }
    return open;
  }
};

const test::Registration<SolidsTest> registration;

}  // namespace pbffd

#include "solids_test.moc"
