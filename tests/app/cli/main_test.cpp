#include "tests/app/cli/cli_support.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd {

class MainTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void versionAndHelpGoToStandardOutput() {
    const auto version = test::runPbffd({"--version"});
    QCOMPARE(version.status, 0);
    QVERIFY(version.output.startsWith("pbffd "));
    const auto help = test::runPbffd({"--help"});
    QCOMPARE(help.status, 0);
    for (const char* command : {"info", "place", "edit", "export", "bench"}) {
      QVERIFY2(help.output.contains(command), command);
      const auto own = test::runPbffd({command, "--help"});
      QCOMPARE(own.status, 0);
      QVERIFY2(own.output.contains("Usage"), command);
      QVERIFY(own.errors.isEmpty());
    }
  }

  void placeHelpNamesEveryOption() {
    const QByteArray help = test::runPbffd({"place", "--help"}).output;
    for (const char* option :
         {"--points", "--levels", "--kernel", "--sigma", "--master", "--radius-factor", "--offset",
          "--exterior-share", "--surface", "--regions", "--reach", "--sites", "--seed", "--paper"}) {
      QVERIFY2(help.contains(option), option);
    }
  }

  void wrongUsageIsStatusTwo_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("nothing") << QStringList{};
    QTest::newRow("unknown command") << QStringList{"destroy"};
    QTest::newRow("unknown option") << QStringList{"info", "a.obj", "--loud"};
    QTest::newRow("no file") << QStringList{"info"};
    QTest::newRow("no output") << QStringList{"place", "a.obj"};
    QTest::newRow("no edits") << QStringList{"edit", "a.pbffd", "-o", "b.pbffd"};
    QTest::newRow("no number") << QStringList{"place", "a.obj", "-o", "b.pbffd", "--points", "many"};
    QTest::newRow("out of range") << QStringList{"place", "a.obj", "-o", "b.pbffd", "--points", "0"};
    QTest::newRow("unknown kernel") << QStringList{"place", "a.obj", "-o", "b.pbffd", "--kernel", "round"};
    QTest::newRow("no sites") << QStringList{"place", "a.obj", "-o", "b.pbffd", "--sites", "0"};
    QTest::newRow("value left out") << QStringList{"export", "a.pbffd", "-o"};
  }
  void wrongUsageIsStatusTwo() {
    QFETCH(QStringList, arguments);
    const auto result = test::runPbffd(arguments);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.errors.startsWith("pbffd: "), result.errors.constData());
    QVERIFY2(result.errors.contains("--help says more"), result.errors.constData());
    QVERIFY(result.output.isEmpty());
  }

  void unknownCommandIsNamed() {
    QVERIFY(test::runPbffd({"destroy"}).errors.startsWith("pbffd: 'destroy' is no command of this program."));
    QVERIFY(test::runPbffd({"info", "a.obj", "--loud"}).errors.contains("Usage: pbffd info"));
  }

  void fullStandardOutputIsAnError() {
    if (!QFile::exists("/dev/full")) {
      QSKIP("no /dev/full here");
    }
    const test::CommandFolder folder;
    const QString mesh = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QProcess process;
    process.setStandardOutputFile("/dev/full");
    process.start(test::pbffdProgram(), {"info", mesh});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains("standard output"));
  }
};

const test::Registration<MainTest> registration;

}  // namespace pbffd

#include "main_test.moc"
