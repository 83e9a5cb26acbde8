#include "core/base/error.h"
#include "tests/core/mesh/io/io_support.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cstdint>

namespace pbffd {

using namespace test;

namespace {

const std::string text =
    "solid a\r\n facet normal 0.0 0 1\r\n outer loop\r\n vertex 0 0 0\r\n vertex 1.0 0 0\r\n vertex 0 1 0\r\n "
    "endloop\r\n endfacet\r\n"
    " facet normal 0 0 0\r\n outer loop\r\n vertex 0 0 0\r\n vertex 1.00 0 0\r\n vertex 0 0 5\r\n endloop\r\n "
    "endfacet\r\nendsolid a";

std::string binary(float moved, float zx, float zz) {
  std::string header = "solid but binary";
  header.resize(80, '\0');
  const std::uint16_t used = 0xABCD;
  return header + bytesOf(2U) + bytesOf(0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, used) +
         bytesOf(0.F, zx, zz, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, -1.F, moved, used);
}

}  // namespace

class StlRewriteTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void weldedVerticesMoveAlikeInAllFacets() {
    const Mesh mesh = parsed("a.stl", text);
    QCOMPARE(rewritten(mesh, atRest(mesh)), text);
    DeformedShape shape = atRest(mesh);
    shape.positions(1, 0) = 2.5;
    std::string expected = replaced(text, "1.0 0 0", "2.5 0 0");
    expected = replaced(expected, "1.00 0 0", "2.5 0 0");
    expected = replaced(expected, "normal 0.0 0 1", "normal 0 0 1");
    QCOMPARE(rewritten(mesh, shape), expected);
  }

  void normalsTurnWithTheirFacetsAndZeroStays() {
    const Mesh mesh = parsed("a.stl", replaced(text, "0.0 0 1", "0 0 -1"));
    DeformedShape shape = atRest(mesh);
    shape.positions.row(2) = Vec3(0, 0, 1);
    const Mesh again = parsed("a.stl", rewritten(mesh, shape));
    // Against the winding as in the source.
    QCOMPARE(attribute(again, "normal", AttributeDomain::face)->values,
             (std::vector<double>{0, 1, 0, 0, 0, 0}));
  }

  void facetsWithoutAreaKeepTheirNormal() {
    const Mesh mesh = parsed("a.stl", text);
    DeformedShape shape = atRest(mesh);
    shape.positions.row(2) = Vec3(0.5, 0, 0);
    QVERIFY(rewritten(mesh, shape).find("normal 0.0 0 1") != std::string::npos);
  }

  void binaryKeepsAllOtherBytes() {
    const std::string source = binary(0.F, 0.F, -1.F);
    const Mesh mesh = parsed("a.stl", source);
    QCOMPARE(rewritten(mesh, atRest(mesh)), source);
    DeformedShape shape = atRest(mesh);
    shape.positions.row(3) = Vec3(0, -1, 0);
    QCOMPARE(rewritten(mesh, shape), source);
    shape.positions.row(3) = Vec3(0, -1, 1e-3);
    const std::string result = rewritten(mesh, shape);
    QCOMPARE(result.size(), source.size());
    QCOMPARE(result.substr(0, 84 + 50), source.substr(0, 84 + 50));
    const std::size_t z = 84 + 50 + 12 + 24 + 8;
    QCOMPARE(result.substr(z), bytesOf(1e-3F) + source.substr(z + 4));
  }

  void floatsAreRefusedWhereTheShapeIsTooLarge() {
    const Mesh mesh = parsed("a.stl", binary(0.F, 0.F, -1.F));
    QVERIFY_EXCEPTION_THROWN(rewritten(mesh, moved(mesh, Mat3::Identity(), Vec3(0, 1e39, 0))), InvalidInput);
  }
};

const test::Registration<StlRewriteTest> registration;

}  // namespace pbffd

#include "stl_rewrite_test.moc"
