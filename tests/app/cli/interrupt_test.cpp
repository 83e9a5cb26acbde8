#include "tests/app/cli/cli_support.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QElapsedTimer>
#include <QProcess>
#include <QtTest>

#include <csignal>

namespace pbffd {

class InterruptTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void interruptStopsLongWorkAndLeavesTheOutput() {
    const test::CommandFolder folder;
    const QString mesh = folder.writeObj("large.obj", test::sphere(500, 600));
    folder.write("out.pbffd", "what was there");
    QProcess process;
    process.start(test::pbffdProgram(), {"place", mesh, "-o", folder.path("out.pbffd"), "--sites", "all"});
    expectToStop(process);
    QCOMPARE(folder.read("out.pbffd"), QByteArray("what was there"));
  }

  void interruptEndsTheWaitForInput() {
    const test::CommandFolder folder;
    QProcess process;
    process.start(test::pbffdProgram(), {"edit", "a.pbffd", "--edits", "-", "-o", folder.path("out.pbffd")});
    expectToStop(process);
    QCOMPARE(folder.read("out.pbffd"), QByteArray("(no file)"));
  }

 private:
  /// Interrupts the program while it works; it has to end by itself, within a second and what a busy machine
  /// adds to that.
  static void expectToStop(QProcess& process) {
    QVERIFY(process.waitForStarted());
    QVERIFY(!process.waitForFinished(700));
    QElapsedTimer timer;
    timer.start();
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
    QVERIFY(process.waitForFinished(10'000));
    QVERIFY2(timer.elapsed() < 2'000, qPrintable(QString::number(timer.elapsed())));
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 1);
    QVERIFY(process.readAllStandardError().contains("Cancelled"));
  }
};

const test::Registration<InterruptTest> registration;

}  // namespace pbffd

#include "interrupt_test.moc"
