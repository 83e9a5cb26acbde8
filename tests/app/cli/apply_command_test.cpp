#include "tests/app/cli/cli_support.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QProcess>
#include <QtTest>

#include <csignal>

namespace pbffd {
namespace {

/// A tetrahedron as a VTK data set, as text.
const QByteArray tetrahedron = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">
  <UnstructuredGrid><Piece NumberOfPoints="4" NumberOfCells="1">
    <Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
      0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points>
    <Cells>
      <DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
      <DataArray type="Int64" Name="offsets" format="ascii">4</DataArray>
      <DataArray type="UInt8" Name="types" format="ascii">10</DataArray>
    </Cells>
  </Piece></UnstructuredGrid>
</VTKFile>
)";

}  // namespace

class ApplyCommandTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void ownMeshComesOutAsByExport() {
    const test::CommandFolder folder;
    const QString project = movedProject(folder);
    QCOMPARE(test::runPbffd({"export", project, "-o", folder.path("a.obj")}).status, 0);
    const auto result =
        test::runPbffd({"apply", project, folder.path("sphere.obj"), "-o", folder.path("b.obj")});
    QVERIFY2(result.status == 0, result.errors);
    QVERIFY2(result.output.startsWith("Deformed ") && result.output.contains("b.obj"), result.output);
    QCOMPARE(folder.read("b.obj"), folder.read("a.obj"));
    QVERIFY(folder.read("b.obj") != folder.read("sphere.obj"));
  }

  void volumeCellsAreMentioned() {
    const test::CommandFolder folder;
    folder.write("a.vtu", tetrahedron);
    const auto result =
        test::runPbffd({"apply", movedProject(folder), folder.path("a.vtu"), "-o", folder.path("b.vtu")});
    QVERIFY2(result.status == 0, result.errors);
    QVERIFY2(result.errors.contains("volume cells") && result.errors.contains("reach: all"), result.errors);
    QVERIFY(folder.read("b.vtu").contains("UnstructuredGrid"));
  }

  void alignmentIsTold() {
    const test::CommandFolder folder;
    const auto result = test::runPbffd({"apply", movedProject(folder), folder.path("sphere.obj"), "-o",
                                        folder.path("b.obj"), "--align", "similarity"});
    QVERIFY2(result.status == 0, result.errors);
    QVERIFY2(result.errors.contains("Aligned to the project's mesh: scale 1,"), result.errors);
  }

  void whatCannotBeDoneLeavesTheOutput_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("status");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("no such file") << QStringList{"none.vtu"} << 1 << QByteArray("none.vtu");
    QTest::newRow("no such array") << QStringList{"a.vtu", "--transport", "velocity"} << 1
                                   << QByteArray("'velocity' of");
    QTest::newRow("a nameless array") << QStringList{"a.vtu", "--transport", ":vector"} << 1
                                      << QByteArray("names none");
    QTest::newRow("an unknown fit") << QStringList{"a.vtu", "--align", "affine"} << 2 << QByteArray("align");
    QTest::newRow("no mesh") << QStringList{} << 2 << QByteArray("MESH");
  }
  void whatCannotBeDoneLeavesTheOutput() {
    QFETCH(QStringList, arguments);
    QFETCH(int, status);
    QFETCH(QByteArray, said);
    const test::CommandFolder folder;
    folder.write("a.vtu", tetrahedron);
    folder.write("b.vtu", "what was there");
    QStringList all{"apply", movedProject(folder)};
    if (!arguments.isEmpty()) {
      all += folder.path(arguments.takeFirst());
    }
    const auto result = test::runPbffd(all + QStringList{"-o", folder.path("b.vtu")} + arguments);
    QCOMPARE(result.status, status);
    QVERIFY2(result.errors.contains(said), result.errors);
    QCOMPARE(folder.read("b.vtu"), QByteArray("what was there"));
  }

  void endedProgramLeavesNothingBehind() {
    const test::CommandFolder folder;
    const QString project = movedProject(folder);
    // A pipe that nobody writes to: the program waits for its input and cannot stop by itself.
    QCOMPARE(QProcess::execute("mkfifo", {folder.path("a.vtu")}), 0);
    const QStringList before = QDir(folder.path(".")).entryList(QDir::AllEntries | QDir::Hidden);
    QProcess process;
    process.start(test::pbffdProgram(), {"apply", project, folder.path("a.vtu"), "-o", folder.path("b.vtu")});
    QVERIFY(process.waitForStarted());
    QVERIFY(!process.waitForFinished(700));
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
    QVERIFY(process.waitForFinished(10'000));
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains("Cancelled"));
    QCOMPARE(QDir(folder.path(".")).entryList(QDir::AllEntries | QDir::Hidden), before);
  }

 private:
  /// A sphere's project with some points moved.
  static QString movedProject(const test::CommandFolder& folder) {
    const QString project = folder.placedSphere("rest.pbffd");
    const auto moved =
        test::runPbffd({"edit", project, "--edits", "-", "-o", folder.path("moved.pbffd")},
                       R"([{"move": {"level": 2, "points": [1, 2, 3], "by": [0.25, 0, 0.125]}}])");
    return moved.status == 0 ? folder.path("moved.pbffd") : QString();
  }
};

const test::Registration<ApplyCommandTest> registration;

}  // namespace pbffd

#include "apply_command_test.moc"
