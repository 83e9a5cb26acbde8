#include "core/base/error.h"
#include "tests/core/mesh/io/io_support.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cmath>

namespace pbffd {

using namespace test;

namespace {

const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

}  // namespace

class OffReadTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void countsInEveryPlace_data() {
    QTest::addColumn<QString>("start");
    QTest::newRow("own line") << "OFF\n3 1 3\n";
    QTest::newRow("same line") << "OFF 3 1 3\n";
    QTest::newRow("without a space") << "OFF3 1 3\n";
    QTest::newRow("no edges") << "OFF\n3 1\n";
    QTest::newRow("a line each") << "OFF\n3\n1\n0\n";
    QTest::newRow("comments") << "# made\nOFF # kind\n\n# counts\n3 1 0 # three\n# first\n";
    QTest::newRow("CRLF") << "OFF\r\n3 1 0\r\n";
  }
  void countsInEveryPlace() {
    QFETCH(QString, start);
    const Mesh mesh = parsed("a.off", start.toStdString() + triangle);
    QCOMPARE(mesh.vertexCount(), 3);
    QCOMPARE(mesh.positions(1, 0), 1.0);
    QCOMPARE(mesh.positions(2, 1), 1.0);
    QCOMPARE(mesh.faces.vertices(), (std::vector<Index>{0, 1, 2}));
    QVERIFY(mesh.remarks.empty());
  }

  void facesOfAnySizeStay() {
    const Mesh mesh = parsed("a.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n2 0 1");
    QCOMPARE(mesh.faces.offsets(), (std::vector<Index>{0, 4, 7, 9}));
    QCOMPARE(mesh.remarks.size(), std::size_t{1});
  }

  void normalsColoursAndTextureCoordinatesOfVertices() {
    const Mesh mesh =
        parsed("a.off", "STCNOFF\n2 0 0\n0 0 0  0 0 1  255 0 128 255  0.5 0.25\n1 0 0  1 0 0  1 2 3 4  1 0\n");
    QCOMPARE(attribute(mesh, "normal", AttributeDomain::vertex)->values,
             (std::vector<double>{0, 0, 1, 1, 0, 0}));
    QCOMPARE(attribute(mesh, "color", AttributeDomain::vertex)->values,
             (std::vector<double>{255, 0, 128, 255, 1, 2, 3, 4}));
    QCOMPARE(attribute(mesh, "texture", AttributeDomain::vertex)->values,
             (std::vector<double>{0.5, 0.25, 1, 0}));
  }

  void coloursWithoutTheirLetterAreKept() {
    const Mesh mesh = parsed("a.off", "OFF\n1 0 0\n0 0 0 0.5 0.5 0.5\n");
    QCOMPARE(attribute(mesh, "color", AttributeDomain::vertex)->width, 3);
  }

  void coloursOfFacesMayBeOfAnyKindOrMissing() {
    const Mesh mesh =
        parsed("a.off",
               "OFF\n3 4 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 1 2\n3 0 1 2 7\n3 0 1 2 0.1 0.2 0.3 1\n");
    const Attribute* colors = attribute(mesh, "color", AttributeDomain::face);
    QVERIFY(colors != nullptr);
    QCOMPARE(colors->width, 4);
    QCOMPARE(colors->values[0], 255.0);
    QVERIFY(std::isnan(colors->values[3]));
    QVERIFY(std::isnan(colors->values[4]));
    QCOMPARE(colors->values[8], 7.0);
    QCOMPARE(colors->values[15], 1.0);
    QCOMPARE(mesh.remarks.size(), std::size_t{1});
  }

  void whatFollowsTheFacesIsRemarked() {
    const Mesh mesh = parsed("a.off", "OFF\n3 1 0\n" + triangle + "\n2 0 1\n");
    QCOMPARE(mesh.remarks.size(), std::size_t{1});
    QVERIFY(mesh.remarks[0].find("line 8") != std::string::npos);
  }

  void errorsNameTheLineAndTheReason_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("message");
    const QString v = "0 0 0\n1 0 0\n0 1 0\n";
    QTest::newRow("header") << "FOO\n3 1 0\n" + v << "Line 1: the file begins with \"FOO\" and not with OFF";
    QTest::newRow("no header") << "3 1 0\n" + v << "Line 1: the file begins with \"3\"";
    QTest::newRow("binary") << "OFF BINARY\n"
                            << "Line 1: this is a binary OFF file, which is not read. Export it as text";
    QTest::newRow("four dimensions") << "4OFF\n1 0 0\n0 0 0 1\n"
                                     << "Line 1: \"4OFF\" holds points of more than three dimensions";
    QTest::newRow("n dimensions") << "nOFF\n4\n1 0 0\n"
                                  << "Line 1: \"nOFF\" holds points";
    QTest::newRow("no counts") << "OFF\n"
                               << "Line 2: the file ends where the number of vertices belongs";
    QTest::newRow("negative count") << "OFF\n-3 1 0\n"
                                    << "Line 2: the number of vertices is -3";
    QTest::newRow("fraction")
        << "OFF\n3.5 1 0\n"
        << "Line 2: \"3.5\" stands where the number of vertices belongs, and is no whole number";
    QTest::newRow("huge count") << "OFF\n3000000000 1 0\n" + v
                                << "Line 2: the file promises 3000000000 vertices and 1 faces, but only";
    QTest::newRow("huge faces") << "OFF\n3 9000000000000000000 0\n" + v << "Line 2: the file promises";
    QTest::newRow("cut in vertices") << "OFF\n3 0 0\n0.00 0.000 0.000\n1 0 0\n0 1"
                                     << "Line 5: the file ends after 2 of 3 vertices. The file may be cut off";
    QTest::newRow("cut in faces") << "OFF\n3 2 0\n" + v + "3 0 1 2\n3 0 1"
                                  << "Line 7: the file ends after 1 of 2 faces";
    QTest::newRow("no number") << "OFF\n3 1 0\n0 0 0\n1 a 0\n0 1 0\n3 0 1 2\n"
                               << "Line 4: \"a\" stands where a coordinate of a vertex belongs";
    QTest::newRow("nan") << "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"
                         << "Line 4: a coordinate of a vertex is \"nan\"";
    QTest::newRow("beyond") << "OFF\n3 1 0\n" + v + "3 0 1 3\n"
                            << "Line 6: a face names vertex 3, but the file has 3, counted from 0";
    QTest::newRow("negative") << "OFF\n3 1 0\n" + v + "3 0 1 -1\n"
                              << "Line 6: a face names vertex -1";
    QTest::newRow("negative size") << "OFF\n3 1 0\n" + v + "-3 0 1 2\n"
                                   << "Line 6: a face has -3 corners";
    QTest::newRow("huge size") << "OFF\n3 1 0\n" + v + "2000000000 0 1 2\n"
                               << "Line 7: the file ends after 0 of 1 faces";
    QTest::newRow("two extras") << "OFF\n1 0 0\n0 0 0 1 2\n"
                                << "Line 3: a vertex has 2 numbers behind its position, which are no colour";
    QTest::newRow("many extras") << "OFF\n1 0 0\n0 0 0 1 2 3 4 5 6 7\n"
                                 << "Line 3: \"7\" is one number too many";
    QTest::newRow("long colour") << "OFF\n3 1 0\n" + v + "3 0 1 2 1 2 3 4 5\n"
                                 << "Line 6: the colour of a face has 5 numbers";
    QTest::newRow("no vertices") << "OFF\n0 0 0\n"
                                 << "It holds no vertices";
    QTest::newRow("empty") << ""
                           << "The file is empty";
  }
  void errorsNameTheLineAndTheReason() {
    QFETCH(QString, text);
    QFETCH(QString, message);
    const QString said = QString::fromStdString(failureOf("scan.off", text.toStdString()));
    QVERIFY2(said.startsWith("Could not read scan.off. " + message), qPrintable(said));
    QVERIFY2(said.count(". ") >= 2, "the advice is missing");
  }
};

const test::Registration<OffReadTest> registration;

}  // namespace pbffd

#include "off_read_test.moc"
