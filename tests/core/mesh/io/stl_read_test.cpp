#include "core/base/error.h"
#include "tests/core/mesh/io/io_support.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>
#include <cstdint>

namespace pbffd {

using namespace test;

namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "  facet normal 0 0 1\n    outer loop\n      vertex " + a + "\n      vertex " + b + "\n      vertex " +
         c + "\n    endloop\n  endfacet\n";
}

std::string binary(const std::string& start, std::uint32_t count, const std::string& facets) {
  std::string header = start;
  header.resize(80, ' ');
  return header + bytesOf(count) + facets;
}

std::string binaryFacet(float x, std::uint16_t attribute = 0) {
  return bytesOf(0.F, 0.F, 1.F, 0.F, 0.F, 0.F, x, 0.F, 0.F, 0.F, 1.F, 0.F, attribute);
}

}  // namespace

class StlReadTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void textIsWeldedInTheOrderOfFirstOccurrence() {
    const Mesh mesh = parsed("a.stl", "solid two words facet\n" + facet("1 0 0", "0 1 0", "0 0 0") +
                                          facet("-0 0.0 0e5", "0 1.0 0", "-1 0 0") + "endsolid two words\n");
    QCOMPARE(mesh.vertexCount(), 4);
    QCOMPARE(mesh.positions(0, 0), 1.0);
    QCOMPARE(mesh.positions(3, 0), -1.0);
    QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 2, 2, 1, 3}));
    QCOMPARE(attribute(mesh, "normal", AttributeDomain::face)->values, (std::vector<double>{0, 0, 1, 0, 0, 1}));
  }

  void nearIsNotTheSame() {
    const Mesh mesh =
        parsed("a.stl", "solid\n" + facet("1 0 0", "1.0000000000000002 0 0", "0 0 0") + "endsolid");
    QCOMPARE(mesh.vertexCount(), 3);
  }

  void keywordsInCapitalsAndSeveralSolids() {
    std::string upper = facet("1 0 0", "0 1 0", "0 0 0");
    std::ranges::transform(upper, upper.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    const Mesh mesh = parsed("a.stl", "SOLID a\r\n" + upper + "ENDSOLID a\r\nsolid b\n" + upper + "endsolid b");
    QCOMPARE(mesh.faces.size(), 2);
    QCOMPARE(mesh.vertexCount(), 3);
  }

  void facetsOfMoreVerticesStay() {
    std::string quad = facet("0 0 0", "1 0 0", "1 1 0");
    quad = replaced(quad, "    endloop", "      vertex 0 1 0\n    endloop");
    QCOMPARE(parsed("a.stl", "solid\n" + quad + "endsolid").faces.offsets(), (std::vector<Index>{0, 4}));
  }

  void binaryIsWelded() {
    const Mesh mesh = parsed("a.stl", binary("made", 2, binaryFacet(1.F) + binaryFacet(2.F)));
    QCOMPARE(mesh.vertexCount(), 4);
    QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 2, 0, 3, 2}));
    QCOMPARE(mesh.attributes.size(), std::size_t{1});
  }

  void binaryMayBeginWithSolid() {
    QCOMPARE(parsed("a.stl", binary("solid of facets", 1, binaryFacet(1.F))).vertexCount(), 3);
    const Mesh mesh = parsed("a.stl", binary("solid of facets", 1, binaryFacet(1.F) + "tail"));
    QCOMPARE(mesh.vertexCount(), 3);
    QCOMPARE(mesh.remarks.size(), std::size_t{1});
    QVERIFY(mesh.remarks[0].starts_with("The last 4 bytes"));
  }

  void attributeBytesAreKept() {
    const Mesh mesh = parsed("a.stl", binary("", 2, binaryFacet(1.F) + binaryFacet(2.F, 513)));
    QCOMPARE(attribute(mesh, "attribute", AttributeDomain::face)->values, (std::vector<double>{0, 513}));
  }

  void errorsNameThePlaceAndTheReason_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& bytes, const char* message) {
      QTest::newRow(name) << QByteArray::fromStdString(bytes) << QString(message);
    };
    const std::string text = "solid\n" + facet("1 0 0", "0 1 0", "0 0 0");
    row("no endsolid", text,
        "Line 9: the file ends where \"facet\" or \"endsolid\" belongs. The file may be cut off");
    row("cut in a facet", text.substr(0, 80), "Line 6: the file ends within a facet. The file may be cut off");
    row("cut in a number", "solid\nfacet normal 0 0", "Line 2: the file ends where \"outer\" belongs");
    row("two vertices", replaced(text, "vertex 0 1 0", "") + "endsolid",
        "Line 7: a facet has 2 vertices and needs 3");
    row("other word", replaced(text, "outer", "inner"), "Line 3: \"inner\" stands where \"outer\" belongs");
    row("outside", text + "endsolid\nfacet", "Line 10: \"facet\" stands where \"solid\" belongs");
    row("no number", replaced(text, "0 1 0", "0 b 0") + "endsolid",
        "Line 8: \"b\" stands where a coordinate of a vertex belongs");
    row("nan", replaced(text, "0 1 0", "0 nan 0") + "endsolid", "Line 8: a coordinate of a vertex is \"nan\"");
    row("nan in binary", binary("", 1, binaryFacet(std::nanf(""))),
        "Byte 108: vertex 1 of facet 0 has a coordinate that is not a finite number");
    row("promise", binary("", 1000000, binaryFacet(1.F)),
        "Byte 80: the header promises 1000000 facets, but the file has room for 1");
    row("half a facet", binary("solid", 2, binaryFacet(1.F) + binaryFacet(1.F).substr(1)),
        "Byte 80: the header promises 2 facets, but the file has room for 1");
    row("short header", std::string(7, '\0'), "Byte 7: the file ends within its header");
    row("other text", "v 0 0 0\n",
        "Line 1: the file begins with \"v\" and not with \"solid\". Choose an STL file");
    row("no facets", binary("", 0, ""), "It holds no vertices");
    row("empty solid", "solid a\nendsolid a\n", "It holds no vertices");
    row("empty", "", "The file is empty");
  }
  void errorsNameThePlaceAndTheReason() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, message);
    const QString said = QString::fromStdString(failureOf("part.stl", bytes.toStdString()));
    QVERIFY2(said.startsWith("Could not read part.stl. " + message), qPrintable(said));
    QVERIFY2(said.count(". ") >= 2, "the advice is missing");
  }
};

const test::Registration<StlReadTest> registration;

}  // namespace pbffd

#include "stl_read_test.moc"
