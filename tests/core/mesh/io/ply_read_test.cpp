#include "core/base/error.h"
#include "tests/core/mesh/io/io_support.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>
#include <cstdint>

namespace pbffd {

using namespace test;

namespace {

std::string header(const std::string& encoding, const std::string& rest) {
  return "ply\nformat " + encoding + " 1.0\ncomment made in a test\nobj_info none\n" + rest + "end_header\n";
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string faceList = "property list uchar int vertex_indices\n";
const std::string corners = "0 0 0\n1 0 0\n0 1 0\n";
const std::string asciiTriangle =
    header("ascii", "element vertex 3\n" + xyz + "element face 1\n" + faceList) + corners + "3 0 1 2\n";

}  // namespace

class PlyReadTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void textIsRead() {
    const Mesh mesh = parsed("a.ply", asciiTriangle);
    QCOMPARE(mesh.vertexCount(), 3);
    QCOMPARE(mesh.positions(1, 0), 1.0);
    QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 2}));
    QVERIFY(mesh.remarks.empty());
    QVERIFY(mesh.attributes.empty());
  }

  void textPositionsAreTheDoublesOfTheText() {
    const Mesh mesh = parsed("a.ply", replaced(asciiTriangle, "1 0 0", "0.1 0 0"));
    QCOMPARE(mesh.positions(1, 0), 0.1);
  }

  void bothBinaryOrdersAreRead() {
    const std::string rest =
        "element vertex 2\nproperty double x\nproperty float y\nproperty short z\nproperty uchar red\n"
        "element face 1\nproperty list ushort uint vertex_index\n";
    const auto check = [](const Mesh& mesh) {
      QCOMPARE(mesh.positions(0, 0), 0.1);
      QCOMPARE(mesh.positions(0, 1), double(0.2F));
      QCOMPARE(mesh.positions(1, 2), -7.0);
      QCOMPARE(mesh.faces.offsets(), (std::vector<Index>{0, 4}));
      QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 1, 0}));
      QCOMPARE(attribute(mesh, "red", AttributeDomain::vertex)->values, (std::vector<double>{200, 3}));
    };
    const std::int16_t z0 = 5;
    const std::int16_t z1 = -7;
    const std::uint8_t red0 = 200;
    const std::uint8_t red1 = 3;
    const std::uint16_t four = 4;
    check(parsed("a.ply", header("binary_little_endian", rest) +
                              bytesOf(0.1, 0.2F, z0, red0, 1.0, 2.0F, z1, red1, four, 0U, 1U, 1U, 0U)));
    check(parsed("a.ply", header("binary_big_endian", rest) +
                              swappedBytesOf(0.1, 0.2F, z0, red0, 1.0, 2.0F, z1, red1, four, 0U, 1U, 1U, 0U)));
  }

  void lineEndsOfTheHeaderMayBeOfAnyKind() {
    const std::string data = bytesOf(std::uint8_t{10}, 1.0F, 2.0F, 3.0F);
    const std::string rest = "element vertex 1\nproperty uchar a\n" + xyz;
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      std::string text;
      for (const char c : header("binary_little_endian", rest)) {
        text += c == '\n' ? end : std::string(1, c);
      }
      const Mesh mesh = parsed("a.ply", text + data);
      QCOMPARE(mesh.positions(0, 2), 3.0);
      QCOMPARE(attribute(mesh, "a", AttributeDomain::vertex)->values, (std::vector<double>{10}));
    }
  }

  void facesMayComeBeforeVertices() {
    const Mesh mesh =
        parsed("a.ply", header("ascii", "element face 1\n" + faceList + "element vertex 3\n" + xyz) +
                            "3 0 1 2\n" + corners);
    QCOMPARE(mesh.faces.size(), 1);
  }

  void pointsAloneAreAMesh() {
    const Mesh mesh = parsed("a.ply", header("ascii", "element vertex 3\n" + xyz) + corners);
    QCOMPARE(mesh.vertexCount(), 3);
    QVERIFY(mesh.faces.empty());
  }

  void propertiesAreAttributes() {
    const std::string rest = "element vertex 3\n" + xyz +
                             "property float nx\nproperty uchar red\nelement face 2\nproperty int material\n" +
                             faceList + "property float quality\nproperty list uchar float texcoord\n";
    const Mesh mesh = parsed("a.ply", header("ascii", rest) +
                                          "0 0 0 0.5 255\n1 0 0 0.25 1\n0 1 0 1 2\n"
                                          "7 3 0 1 2 0.5 6 0 0 1 0 0 1\n8 3 2 1 0 0.75 0\n");
    QCOMPARE(attribute(mesh, "nx", AttributeDomain::vertex)->values, (std::vector<double>{0.5, 0.25, 1}));
    QCOMPARE(attribute(mesh, "red", AttributeDomain::vertex)->values, (std::vector<double>{255, 1, 2}));
    QCOMPARE(attribute(mesh, "material", AttributeDomain::face)->values, (std::vector<double>{7, 8}));
    QCOMPARE(attribute(mesh, "quality", AttributeDomain::face)->values, (std::vector<double>{0.5, 0.75}));
    const Attribute* texture = attribute(mesh, "texcoord", AttributeDomain::corner);
    QVERIFY(texture != nullptr);
    QCOMPARE(texture->values, (std::vector<double>{0, 0, 1, 0, 0, 1}));
    QCOMPARE(texture->rowOfCorner, (std::vector<Index>{0, 1, 2, -1, -1, -1}));
    QVERIFY(mesh.remarks.empty());
  }

  void stripsBecomeTriangles() {
    const std::string rest =
        "element vertex 5\n" + xyz + "element tristrips 1\nproperty list int int vertex_indices\n";
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n";
    const Mesh mesh = parsed("a.ply", header("ascii", rest) + points + "9 0 1 2 3 -1 2 3 4 4\n");
    QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 2, 2, 1, 3, 2, 3, 4}));
    QCOMPARE(mesh.remarks.size(), std::size_t{1});
    QVERIFY(mesh.remarks[0].starts_with("1 triangle of the strips"));
  }

  void stripsOfUnsignedNumbersBeginAnewAtTheLargest() {
    const std::string rest =
        "element vertex 3\n" + xyz + "element tristrips 1\nproperty list uchar uint vertex_indices\n";
    const std::string data =
        bytesOf(0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, std::uint8_t{7}, 0U, 1U, 2U, ~0U, 2U, 1U, 0U);
    const Mesh mesh = parsed("a.ply", header("binary_little_endian", rest) + data);
    QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 2, 2, 1, 0}));
  }

  void stripsBesideFacesHaveNoFaceAttributes() {
    const std::string rest = "element vertex 3\n" + xyz +
                             "element tristrips 1\nproperty list uchar int vertex_indices\nelement face 1\n" +
                             faceList + "property int flag\n";
    const Mesh mesh = parsed("a.ply", header("ascii", rest) + corners + "3 0 1 2\n3 2 1 0 5\n");
    const std::vector<double>& flags = attribute(mesh, "flag", AttributeDomain::face)->values;
    QCOMPARE(flags.size(), std::size_t{2});
    QVERIFY(std::isnan(flags[0]));
    QCOMPARE(flags[1], 5.0);
  }

  void whatIsNotShownIsRemarked() {
    const std::string rest =
        "element vertex 3\n" + xyz +
        "property list uchar int weights\nelement edge 2\nproperty int vertex1\nelement nothing 0\n"
        "element face 1\n" +
        faceList + "property list uchar float texcoord\n";
    const Mesh mesh =
        parsed("a.ply", header("ascii", rest) + "0 0 0 0\n1 0 0 2 7 7\n0 1 0 1 3\n4 5\n3 0 1 2 1 9\nrest");
    QCOMPARE(mesh.positions(2, 1), 1.0);
    QCOMPARE(mesh.remarks.size(), std::size_t{4});
  }

  void errorsNameThePlaceAndTheReason_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const std::string& bytes, const char* message) {
      QTest::newRow(name) << QByteArray::fromStdString(bytes) << QString(message);
    };
    const std::string v = "element vertex 3\n" + xyz;
    const std::string vf = v + "element face 1\n" + faceList;
    row("no ply", "plx\n", "Line 1: the file begins with \"plx\" and not with \"ply\"");
    row("no end", "ply\nformat ascii 1.0\n", "Line 3: the file ends within its header");
    row("no format", "ply\nelement vertex 1\nend_header\n",
        "Line 3: the header ends without a line \"format\"");
    row("other format", "ply\nformat hex 1.0\n", "Line 2: \"hex\" is no format of PLY");
    row("other version", "ply\nformat ascii 2.0\n", "Line 2: the version of the format is \"2.0\"");
    row("other word", "ply\nformat ascii 1.0\nfoo\n", "Line 3: \"foo\" is no word of a PLY header");
    row("early property", "ply\nformat ascii 1.0\nproperty int x\n",
        "Line 3: a property comes before the first element");
    row("other type", header("ascii", "element vertex 1\nproperty half x\n"),
        "Line 6: \"half\" is no type of PLY");
    row("float count", header("ascii", "element face 1\nproperty list float int vertex_index\n"),
        "Line 6: the length of a list has a type");
    row("nameless", header("ascii", "element vertex 1\nproperty int\n"), "Line 6: a property has no name");
    row("property twice", header("ascii", "element vertex 1\nproperty int x\nproperty int x\n"),
        "Line 7: the property \"x\" is there twice");
    row("element twice", header("ascii", v + v), "Line 9: the element \"vertex\" is there twice");
    row("negative count", header("ascii", "element vertex -1\n"),
        "Line 5: there are -1 of the element \"vertex\"");
    row("no count", header("ascii", "element vertex\n"),
        "Line 5: the line ends where the number of an element belongs");
    row("no vertices", header("ascii", "element face 0\n" + faceList), "Its header has no element \"vertex\"");
    row("no z", header("ascii", "element vertex 0\nproperty int x\nproperty int y\n"),
        "Its vertices have no property \"z\"");
    row("list of x", header("ascii", "element vertex 0\nproperty list int int x\n"),
        "Its vertices have no property \"x\"");
    row("no corners", header("ascii", v + "element face 1\nproperty int a\n") + corners + "1\n",
        "Its element \"face\" has no list \"vertex_indices\"");
    row("huge count", header("ascii", "element vertex 2000000000\n" + xyz) + corners,
        "Line 10: the header promises 2000000000 of the element \"vertex\", but only 18 bytes follow");
    row("too many", header("ascii", "element vertex 9000000000000000000\n" + xyz),
        "It has more vertices than can be numbered");
    row("huge binary", header("binary_little_endian", "element vertex 2000000000\n" + xyz),
        "Byte 161: the header promises 2000000000 of");
    row("nan", replaced(asciiTriangle, "1 0 0", "1 nan 0"),
        "Line 13: y of vertex 1 is nan, which is not a finite number");
    row("infinite binary",
        header("binary_little_endian", "element vertex 1\n" + xyz) + bytesOf(1.F, 2.F, HUGE_VALF),
        "Byte 160: z of vertex 0 is inf");
    row("word", replaced(asciiTriangle, "1 0 0", "1 a 0"), "Line 13: \"a\" stands where a number belongs");
    row("cut off", header("ascii", vf) + "0.0 0.0 0.0\n1 0 0\n0 1 0\n3 0.0 1",
        "Line 15: the file ends where a number belongs. The file may be cut off");
    row("cut off binary",
        header("binary_little_endian", vf) + std::string(36, '\0') + bytesOf(std::uint8_t{3}, 0, 1),
        "Byte 242: a list has the length 3, but only 8 bytes follow. The file may be cut off");
    row("no list", header("binary_little_endian", vf) + std::string(36, '\0'),
        "Byte 242: the header promises 1 of the element \"face\", but only 0 bytes follow");
    row("beyond", replaced(asciiTriangle, "3 0 1 2", "3 0 1 3"),
        "Line 15: a face names vertex 3, but the file has 3, counted from 0");
    row("negative", replaced(asciiTriangle, "3 0 1 2", "3 0 1 -1"), "Line 15: a face names vertex -1");
    row("fraction", replaced(asciiTriangle, "3 0 1 2", "3 0 1 1.5"),
        "Line 15: 1.5 stands where a whole number belongs");
    row("negative length", replaced(asciiTriangle, "3 0 1 2", "-3 0 1 2"), "Line 15: a list has the length -3");
    row("huge length", replaced(asciiTriangle, "3 0 1 2", "4000000000 0 1 2"),
        "Line 15: a list has the length 4000000000, but only 7 bytes follow");
    row("end_header", "ply\nformat ascii 1.0\nelement vertex 0\n" + xyz + "end_header x\n",
        "Line 7: something follows \"end_header\"");
    row("zero vertices", header("ascii", "element vertex 0\n" + xyz), "It holds no vertices");
    row("empty", "", "The file is empty");
  }
  void errorsNameThePlaceAndTheReason() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, message);
    const QString said = QString::fromStdString(failureOf("scan.ply", bytes.toStdString()));
    QVERIFY2(said.startsWith("Could not read scan.ply. " + message), qPrintable(said));
    QVERIFY2(said.count(". ") >= 2, "the advice is missing");
  }
};

const test::Registration<PlyReadTest> registration;

}  // namespace pbffd

#include "ply_read_test.moc"
