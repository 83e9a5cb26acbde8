#include "app/dataset/apply.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/project/project_file.h"
#include "tests/app/dataset/fixture.h"
#include "tests/app/dataset/partition_fixture.h"
#include "tests/support/test_main.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

namespace pbffd {
namespace {

constexpr int pieces = 6;
constexpr int patience = 120000;

struct Ended {
  int status = -1;
  QString said;
};

/// Environment of a run on this machine alone, by whichever user.
QProcessEnvironment environment() {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const char* name : {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"}) {
    environment.insert(name, "1");
  }
  return environment;
}

QStringList arguments(int ranks, const QStringList& own) {
  return QStringList{
             "--oversubscribe",      "--mca",        "btl", "self,vader", "--mca", "plm", "isolated", "-n",
             QString::number(ranks), PBFFD_APPLY_MPI} +
         own;
}

Ended run(int ranks, const QStringList& own) {
  QProcess process;
  process.setProcessEnvironment(environment());
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(PBFFD_MPIRUN, arguments(ranks, own));
  process.waitForFinished(patience);
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1, process.readAll()};
}

}  // namespace

class ApplyMpiTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    dir_ = std::make_unique<QTemporaryDir>();
    folder_ = dir_->path().toStdString();
    for (const char* name : {"in", "one", "out"}) {
      std::filesystem::create_directory(folder_ / name);
    }
    test::writePartition(folder_ / "in/run.pvtu", pieces);
    saveProject(folder_ / "bent.pbffd", test::bentProject(Reach::connected));
  }

  void ranksGiveTheBitsOfOneProcess_data() {
    QTest::addColumn<int>("ranks");
    QTest::addColumn<bool>("isAligned");
    for (const int ranks : {1, 2, 4}) {
      QTest::addRow("%d ranks", ranks) << ranks << false;
    }
    QTest::newRow("2 ranks, aligned") << 2 << true;
  }
  void ranksGiveTheBitsOfOneProcess() {
    QFETCH(int, ranks);
    QFETCH(bool, isAligned);
    const Project project = loadProject(folder_ / "bent.pbffd").project;
    ApplyOptions options;
    options.align = isAligned;
    options.transports = {parseTransport("velocity")};
    applyToFile(project, folder_ / "in/run.pvtu", folder_ / "one/run.pvtu", options);
    const Ended ended =
        run(ranks, QStringList{path("bent.pbffd"), path("in/run.pvtu"), "-o", path("out/run.pvtu"),
                               "--transport", "velocity", "--align", isAligned ? "similarity" : "none"});
    QVERIFY2(ended.status == 0, qPrintable(ended.said));
    QVERIFY(ended.said.contains("volume cells"));
    QCOMPARE(test::namesIn(folder_ / "out"), (std::vector<std::string>{"run", "run.pvtu"}));
    QCOMPARE(readFile(folder_ / "out/run.pvtu"), readFile(folder_ / "one/run.pvtu"));
    for (int piece = 0; piece < pieces; ++piece) {
      const std::string name = format("run/{}.vtu", piece);
      QVERIFY(readFile(folder_ / "out" / name) == readFile(folder_ / "one" / name));
    }
  }

  void failingRankIsNamedAndLeavesNothing() {
    const std::string bytes = readFile(folder_ / "in/run/3.vtu");
    writeFileAtomically(folder_ / "in/run/3.vtu", bytes.substr(0, bytes.size() / 2));
    const Ended ended = run(2, {path("bent.pbffd"), path("in/run.pvtu"), "-o", path("out/run.pvtu")});
    QCOMPARE(ended.status, 1);
    QVERIFY2(ended.said.contains("rank 1: piece 4 of 6 ("), qPrintable(ended.said));
    QVERIFY(test::namesIn(folder_ / "out").empty());
  }

  void missingPieceAndOtherFormatsAreErrors() {
    std::filesystem::remove(folder_ / "in/run/3.vtu");
    const Ended missing = run(2, {path("bent.pbffd"), path("in/run.pvtu"), "-o", path("out/run.pvtu")});
    QCOMPARE(missing.status, 1);
    QVERIFY2(missing.said.contains("piece 4 of 6"), qPrintable(missing.said));
    const Ended single = run(2, {path("bent.pbffd"), path("in/run/0.vtu"), "-o", path("out/0.vtu")});
    QCOMPARE(single.status, 1);
    QVERIFY2(single.said.contains("no partitioned data set"), qPrintable(single.said));
    QVERIFY(test::namesIn(folder_ / "out").empty());
  }

  void killedRankLeavesNothing() {
    // A pipe that nobody writes to holds the rank that reads it.
    std::filesystem::remove(folder_ / "in/run/3.vtu");
    QCOMPARE(QProcess::execute("mkfifo", {path("in/run/3.vtu")}), 0);
    QProcess process;
    process.setProcessEnvironment(environment());
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(PBFFD_MPIRUN,
                  arguments(2, {path("bent.pbffd"), path("in/run.pvtu"), "-o", path("out/run.pvtu")}));
    qint64 rank = 0;
    QTRY_VERIFY_WITH_TIMEOUT((rank = childOf(process.processId())) != 0, 20000);
    QTest::qWait(500);
    QCOMPARE(QProcess::execute("kill", {"-KILL", QString::number(rank)}), 0);
    QVERIFY(process.waitForFinished(patience));
    QVERIFY(process.exitCode() != 0);
    QVERIFY2(process.readAll().contains("rank"), "mpirun names the rank");
    QVERIFY(test::namesIn(folder_ / "out").empty());
  }

  void wrongUsageIsStatusTwo() {
    QCOMPARE(run(2, {"--no-such-option"}).status, 2);
    QCOMPARE(run(1, {"--help"}).status, 0);
  }

 private:
  QString path(const char* name) const { return QString::fromStdString((folder_ / name).string()); }

  /// A process that `parent` started; 0 for none.
  static qint64 childOf(qint64 parent) {
    QProcess pgrep;
    pgrep.start("pgrep", {"-P", QString::number(parent), "-f", "pbffd-apply-mpi"});
    pgrep.waitForFinished();
    return pgrep.readAll().split('\n').value(0).toLongLong();
  }

  std::unique_ptr<QTemporaryDir> dir_;
  std::filesystem::path folder_;
};

const test::Registration<ApplyMpiTest> registration;

}  // namespace pbffd

#include "apply_mpi_test.moc"
