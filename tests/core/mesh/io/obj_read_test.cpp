#include "core/base/error.h"
#include "tests/core/mesh/io/io_support.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

using namespace test;

class ObjReadTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void facesOfAnySizeStay() {
    const Mesh mesh =
        parsed("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nf 1 2 3\nf 1 2 3 4\nf 1 2 3 5 4\n");
    QCOMPARE(mesh.vertexCount(), 5);
    QCOMPARE(mesh.faces.offsets(), (std::vector<Index>{0, 3, 7, 12}));
    QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 4, 3}));
    QVERIFY(mesh.remarks.empty());
  }

  void positionsAreTheDoublesOfTheText() {
    const Mesh mesh = parsed("a.obj", "v 0.1 +2.5 -1e-3\nv .5 5. 1E2\nv 1e-400 4.9e-324 123456789.123456789\n");
    QCOMPARE(mesh.positions(0, 0), 0.1);
    QCOMPARE(mesh.positions(0, 1), 2.5);
    QCOMPARE(mesh.positions(0, 2), -0.001);
    QCOMPARE(mesh.positions(1, 0), 0.5);
    QCOMPARE(mesh.positions(1, 1), 5.0);
    QCOMPARE(mesh.positions(1, 2), 100.0);
    QVERIFY(mesh.positions(2, 0) == 0.0);
    QVERIFY(mesh.positions(2, 1) == 4.9e-324);
    QVERIFY(mesh.positions(2, 2) == 123456789.123456789);
  }

  void lineEndsCommentsContinuationsAndTabs() {
    const std::string text =
        "\xEF\xBB\xBF# C:\\dir\\\r\nv 0\t0 0 # first\r\n\r\n  v 1 \\\r\n 0 0\rv 0 1 0\nf 1 2\\\n 3";
    const Mesh mesh = parsed("a.obj", text);
    QCOMPARE(mesh.vertexCount(), 3);
    QCOMPARE(mesh.positions(1, 0), 1.0);
    QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 2}));
  }

  void cornersInEveryForm() {
    const std::string start = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.25 0.5\nvt 1 1\nvn 0 0 1\n";
    const Mesh mesh =
        parsed("a.obj", start + "f 1 2 3\nf 1/1 2/2 3/1\nf 1//1 2//1 3//1\nf 1/2/1 2/1/1 3/1/1\nf 1/ 2/ 3//\n");
    QCOMPARE(mesh.faces.size(), 5);
    const Attribute* texture = attribute(mesh, "vt", AttributeDomain::corner);
    QVERIFY(texture != nullptr);
    QCOMPARE(texture->width, 2);
    QCOMPARE(texture->values, (std::vector<double>{0.25, 0.5, 1, 1}));
    QCOMPARE(texture->rowOfCorner, (std::vector<Index>{-1, -1, -1, 0, 1, 0, -1, -1, -1, 1, 0, 0, -1, -1, -1}));
    const Attribute* normals = attribute(mesh, "vn", AttributeDomain::corner);
    QVERIFY(normals != nullptr);
    QCOMPARE(normals->rowOfCorner, (std::vector<Index>{-1, -1, -1, -1, -1, -1, 0, 0, 0, 0, 0, 0, -1, -1, -1}));
  }

  void negativeIndicesCountFromTheirLine() {
    const Mesh mesh = parsed("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n");
    QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 2, 3, 2, 1}));
  }

  void facesMayComeBeforeVertices() {
    const Mesh mesh = parsed("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
    QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 2}));
  }

  void pointsAloneAreAMesh() {
    const Mesh mesh = parsed("a.obj", "v 1 2 3");
    QCOMPARE(mesh.vertexCount(), 1);
    QVERIFY(mesh.faces.empty());
  }

  void weightsAndColoursOfVerticesAreKept() {
    const Mesh mesh = parsed("a.obj", "v 0 0 0 2\nv 1 0 0\nv 0 1 0 0.5 0.25 1\nv 0 0 1 1 0 0 0.5\n");
    const Attribute* weights = attribute(mesh, "w", AttributeDomain::vertex);
    QVERIFY(weights != nullptr);
    QCOMPARE(weights->values, (std::vector<double>{2, 1, 1, 1}));
    const Attribute* colors = attribute(mesh, "color", AttributeDomain::vertex);
    QVERIFY(colors != nullptr);
    QCOMPARE(colors->width, 4);
    QCOMPARE(colors->values, (std::vector<double>{1, 1, 1, 1, 1, 1, 1, 1, 0.5, 0.25, 1, 1, 1, 0, 0, 0.5}));
    QCOMPARE(mesh.remarks.size(), std::size_t{2});
  }

  void normalsThatNoFaceNamesBelongToTheVertices() {
    const Mesh mesh = parsed("a.obj", "v 0 0 0\nvn 1 0 0\nv 1 0 0\nvn 0 1 0\n");
    const Attribute* normals = attribute(mesh, "vn", AttributeDomain::vertex);
    QVERIFY(normals != nullptr);
    QCOMPARE(normals->values, (std::vector<double>{1, 0, 0, 0, 1, 0}));
    const Mesh other = parsed("a.obj", "v 0 0 0\nvn 1 0 0\nvn 0 1 0\n");
    QVERIFY(attribute(other, "vn", AttributeDomain::corner) != nullptr);
    QCOMPARE(other.remarks.size(), std::size_t{1});
  }

  void whatIsNotShownIsRemarked() {
    const std::string start = "mtllib none.mtl\no a\ng b\ns 1\nusemtl c\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    QVERIFY(parsed("a.obj", start).remarks.empty());
    const Mesh mesh = parsed("a.obj", start + "l 1 2\np 3\ncurv 0 1 1 2\nparm u 0 1\nfoo bar\nvn nan 0 1\n");
    QCOMPARE(mesh.remarks.size(), std::size_t{5});
    const auto holds = [&](const std::string& text) {
      return std::ranges::any_of(mesh.remarks, [&](const auto& one) { return one.find(text) != one.npos; });
    };
    QVERIFY(holds("2 statements of points or lines (p, l), the first on line 10, are kept"));
    QVERIFY(holds("2 statements of free-form curves or surfaces, the first on line 12"));
    QVERIFY(holds("1 statement of a kind that OBJ does not have (\"foo\"), the first on line 14, is kept"));
    QVERIFY(holds("1 of the numbers of the normals (vn) are no finite numbers"));
  }

  void facesOfFewerThanThreeVerticesStayAndAreRemarked() {
    const Mesh mesh = parsed("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\nf 1 2 2 1\nf\n");
    QCOMPARE(mesh.faces.offsets(), (std::vector<Index>{0, 3, 5, 9, 9}));
    QCOMPARE(mesh.remarks.size(), std::size_t{1});
    QCOMPARE(mesh.remarks[0],
             std::string("3 faces name fewer than three different vertices and have no area; the first "
                         "is face 2, counted from 1."));
  }

  void errorsNameTheLineAndTheReason_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    const QString v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    QTest::newRow("beyond")
        << v + "\nf 1 2 4\n"
        << "Line 5: a face names vertex 4, but the file has 3. The file may be cut off; export it again.";
    QTest::newRow("beyond texture") << v + "f 1/1 2 3\n"
                                    << "Line 4: a face names texture coordinates 1, but the file has 0";
    QTest::newRow("beyond normal") << v + "vn 0 0 1\nf 1//2 2 3\n"
                                   << "Line 5: a face names normal 2, but the file has 1";
    QTest::newRow("zero") << v + "f 0 1 2\n"
                          << "Line 4: a face names vertex 0, but OBJ counts from 1";
    QTest::newRow("before the first") << v + "f -4 1 2\n"
                                      << "Line 4: a face names vertex -4, but the file has 3 before it";
    QTest::newRow("huge index") << v + "f 99999999999 1 2\n"
                                << "Line 4: a face names vertex 99999999999";
    QTest::newRow("no index") << v + "f 1 2 three\n"
                              << "Line 4: \"three\" is no corner of a face";
    QTest::newRow("four parts") << v + "f 1/1/1/1 2 3\n"
                                << "Line 4: \"1/1/1/1\" is no corner";
    QTest::newRow("fraction") << v + "f 1.5 2 3\n"
                              << "Line 4: \"1.5\" is no corner";
    QTest::newRow("short vertex") << v + "v 1 2\nf 1 2 3"
                                  << "Line 4: the line ends where a coordinate of a vertex belongs";
    QTest::newRow("cut off")
        << v + "v 1 2"
        << "Line 4: the file ends where a coordinate of a vertex belongs. The file may be cut off";
    QTest::newRow("five numbers") << v + "v 1 2 3 4 5\n"
                                  << "Line 4: a vertex has 5 numbers";
    QTest::newRow("eight numbers") << v + "v 1 2 3 4 5 6 7 8\n"
                                   << "Line 4: a vertex has more than 7 numbers";
    QTest::newRow("malformed")
        << v + "v 1 2 3x\n"
        << "Line 4: \"3x\" stands where a coordinate of a vertex belongs, and is no number";
    QTest::newRow("hexadecimal") << v + "v 1 2 0x10\n"
                                 << "Line 4: \"0x10\" stands";
    QTest::newRow("decimal comma") << v + "v 1,5 2 3\n"
                                   << "Line 4: \"1,5\" stands";
    QTest::newRow("two signs") << v + "v +-1 2 3\n"
                               << "Line 4: \"+-1\" stands";
    QTest::newRow("indefinite") << v + "v 1.#IND 2 3\n"
                                << "Line 4: \"1.#IND\" stands";
    QTest::newRow("nan") << v + "v nan 2 3\n"
                         << "Line 4: a coordinate of a vertex is \"nan\", which is not a finite number";
    QTest::newRow("-nan(ind)") << v + "v -nan(ind) 2 3\n"
                               << "Line 4: a coordinate of a vertex is \"-nan(ind)\"";
    QTest::newRow("infinite") << v + "v 1 2 -inf\n"
                              << "Line 4: a coordinate of a vertex is \"-inf\"";
    QTest::newRow("too large") << v + "v 1 1e999 3\n"
                               << "Line 4: a coordinate of a vertex is \"1e999\", which is not a finite number";
    QTest::newRow("short normal") << v + "vn 0 1\n"
                                  << "Line 4: the line ends where a coordinate of a normal belongs";
    QTest::newRow("long normal") << v + "vn 0 1 0 0\n"
                                 << "Line 4: \"0\" follows the three coordinates of a normal";
    QTest::newRow("texture") << v + "vt 0 1 0 0\n"
                             << "Line 4: there are more than 3 texture coordinates";
    QTest::newRow("empty texture") << v + "vt\n"
                                   << "Line 4: the line ends where a texture coordinate belongs";
    QTest::newRow("continued line") << v + "v 1 \\\n 2 \\\n x\n"
                                    << "Line 6: \"x\" stands";
    QTest::newRow("old line ends") << "v 0 0 0\rv 1 0 x\r"
                                   << "Line 2: \"x\" stands";
    QTest::newRow("binary") << QString(
                                   "\x7f"
                                   "ELF\x02\x01")
                            << "Line 1: there are control characters, so this is no text. Choose an OBJ file";
    QTest::newRow("other text") << "hello world\n"
                                << "It holds no vertices";
    QTest::newRow("blanks") << " \n\n"
                            << "It holds no vertices";
    QTest::newRow("empty") << ""
                           << "The file is empty";
  }
  void errorsNameTheLineAndTheReason() {
    QFETCH(QString, text);
    QFETCH(QString, message);
    const QString said = QString::fromStdString(failureOf("scan.obj", text.toStdString()));
    QVERIFY2(said.startsWith("Could not read scan.obj. " + message), qPrintable(said));
    QVERIFY2(said.count(". ") >= 2, "the advice is missing");
  }

  void cancelStopsReading() {
    std::string text;
    for (int i = 0; i < 20000; ++i) {
      text += "v 0 0 0\n";
    }
    const Progress progress{Progress::Listener()};
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(parseMesh(std::make_shared<const std::string>(text), "a.obj", progress),
                             Cancelled);
  }
};

const test::Registration<ObjReadTest> registration;

}  // namespace pbffd

#include "obj_read_test.moc"
