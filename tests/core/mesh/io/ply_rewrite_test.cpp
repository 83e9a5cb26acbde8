#include "core/base/error.h"
#include "tests/core/mesh/io/io_support.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cstdint>

namespace pbffd {

using namespace test;

namespace {

std::string header(const std::string& encoding, const std::string& type) {
  return "ply\r\nformat " + encoding +
         " 1.0\r\nelement face 1\r\nproperty list uchar int vertex_indices\r\nelement vertex 3\r\n" +
         "property uchar red\r\nproperty " + type + " z\r\nproperty " + type + " y\r\nproperty " + type +
         " x\r\nproperty float nx\r\nproperty float ny\r\nproperty float nz\r\nelement tail 1\r\nproperty int "
         "a\r\nend_header\r\n";
}

}  // namespace

class PlyRewriteTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void onlyTheNumbersOfTextThatMovedChange() {
    const std::string source =
        header("ascii", "float") +
        "3 0 1 2\r\n9 0 0 0.00  1.0 0 0\r\n9 0 0 1.50 0 0 1.0\r\n9 0 1 0 0 0 0 \r\n77\r\nrest";
    const Mesh mesh = parsed("a.ply", source);
    QCOMPARE(rewritten(mesh, atRest(mesh)), source);
    std::string expected = replaced(source, "1.0 0 0\r\n", "0 1 0\r\n");
    expected = replaced(expected, "9 0 0 1.50 0", "9 0 1.5 0 0");
    expected = replaced(expected, "9 0 1 0 0 0 0 ", "9 0 0 -1 0 0 0 ");
    QCOMPARE(rewritten(mesh, moved(mesh, quarterTurn())), expected);
  }

  void onlyTheNumbersOfBinaryThatMovedChange() {
    const std::uint8_t red = 9;
    const auto body = [&](auto join, float x1, float y1) {
      return join(std::uint8_t{3}, 0, 1, 2, red, 0.F, 0.F, 0.F, x1, y1, 0.F, red, 0.F, y1 * 0.1F, x1 * 0.1F,
                  0.F, 0.F, 1.F, red, 2.F, 0.F, 0.F, 0.F, 0.F, -3.F, 77);
    };
    const auto little = [](auto... n) { return bytesOf(n...); };
    const auto big = [](auto... n) { return swappedBytesOf(n...); };
    for (const bool isLittle : {true, false}) {
      const std::string start = header(isLittle ? "binary_little_endian" : "binary_big_endian", "float");
      const std::string source = start + (isLittle ? body(little, 1.F, 0.F) : body(big, 1.F, 0.F));
      const std::string expected = start + (isLittle ? body(little, 0.F, 1.F) : body(big, 0.F, 1.F));
      const Mesh mesh = parsed("a.ply", source);
      QCOMPARE(rewritten(mesh, atRest(mesh)), source);
      DeformedShape shape = moved(mesh, quarterTurn());
      QCOMPARE(rewritten(mesh, shape), expected);
    }
  }

  void doublesReadBackToTheLastBit() {
    const std::string source = header("binary_big_endian", "double") +
                               swappedBytesOf(std::uint8_t{3}, 0, 1, 2) +
                               std::string(3 * (1 + 24 + 12) + 4, '\0');
    const Mesh mesh = parsed("a.ply", source);
    DeformedShape shape = atRest(mesh);
    shape.positions << 0.1, 0.2, 0.3, 1e300, -1e-300, 1.0 / 3.0, 4, 5, 6;
    const std::string bytes = rewritten(mesh, shape);
    QCOMPARE(bytes.size(), source.size());
    QVERIFY(parsed("a.ply", bytes).positions == shape.positions);
  }

  void wholeNumbersAreRefusedWhereTheyCannotHoldTheShape() {
    const std::string source =
        header("ascii", "short") + "3 0 1 2\r\n9 0 0 0 0 0 0\r\n9 0 0 1 0 0 0\r\n9 0 1 0 0 0 0\r\n77\r\n";
    const Mesh mesh = parsed("a.ply", source);
    const std::string shifted = rewritten(mesh, moved(mesh, Mat3::Identity(), Vec3(10, 0, 0)));
    QVERIFY(shifted.ends_with("9 0 0 10 0 0 0\r\n9 0 0 11 0 0 0\r\n9 0 1 10 0 0 0\r\n77\r\n"));
    QVERIFY_EXCEPTION_THROWN(rewritten(mesh, moved(mesh, Mat3::Identity(), Vec3(0.5, 0, 0))), InvalidInput);
    QVERIFY_EXCEPTION_THROWN(rewritten(mesh, moved(mesh, Mat3::Identity(), Vec3(40000, 0, 0))), InvalidInput);
  }

  void floatsAreRefusedWhereTheShapeIsTooLarge() {
    const std::string source =
        header("ascii", "float") + "3 0 1 2\r\n9 0 0 0 0 0 0\r\n9 0 0 1 0 0 0\r\n9 0 1 0 0 0 0\r\n77\r\n";
    const Mesh mesh = parsed("a.ply", source);
    QVERIFY_EXCEPTION_THROWN(rewritten(mesh, moved(mesh, Mat3::Identity(), Vec3(1e39, 0, 0))), InvalidInput);
  }
};

const test::Registration<PlyRewriteTest> registration;

}  // namespace pbffd

#include "ply_rewrite_test.moc"
