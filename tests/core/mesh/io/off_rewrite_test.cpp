#include "tests/core/mesh/io/io_support.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

using namespace test;

class OffRewriteTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void onlyTheNumbersThatMovedChange() {
    const std::string source =
        "CNOFF # kind\r\n3 1 0\r\n# vertices\r\n0 0 0  1.0 0 0  255 0 0\r\n1.00 0 0\t0 0 1.0  0 255 0 # b\r\n"
        "0 2 0  0 0 0  0 0 255\r\n\r\n3  0 1 2  9 9 9\r\nrest";
    const Mesh mesh = parsed("a.off", source);
    QCOMPARE(rewritten(mesh, atRest(mesh)), source);
    std::string expected = replaced(source, "1.0 0 0  255", "0 1 0  255");
    expected = replaced(expected, "1.00 0 0\t", "0 1 0\t");
    expected = replaced(expected, "0 2 0  0", "-2 0 0  0");
    QCOMPARE(rewritten(mesh, moved(mesh, quarterTurn())), expected);
  }

  void movedPositionsReadBackToTheLastBit() {
    const Mesh mesh = parsed("a.off", "OFF3 0 0\n0 0 0\n1 0 0\n0 1 0 # end");
    const DeformedShape shape = moved(mesh, 0.1 * quarterTurn(), Vec3(1.0 / 3.0, 1e-20, 1e20));
    QVERIFY(parsed("a.off", rewritten(mesh, shape)).positions == shape.positions);
  }
};

const test::Registration<OffRewriteTest> registration;

}  // namespace pbffd

#include "off_rewrite_test.moc"
