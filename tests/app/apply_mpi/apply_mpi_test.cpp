#include "app/dataset/apply.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/project/project_file.h"
#include "tests/app/dataset/fixture.h"
#include "tests/app/dataset/partition_fixture.h"
#include "tests/support/test_main.h"

#include <QDir>
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

  void remarksAreToldWhereTheFirstRankHasNoPoints() {
    for (const char* piece : {"0", "2", "4"}) {
      test::writeEmptyPiece(folder_ / "in/run" / (std::string(piece) + ".vtu"));
    }
    const Ended ended = run(2, {path("bent.pbffd"), path("in/run.pvtu"), "-o", path("out/run.pvtu")});
    QVERIFY2(ended.status == 0, qPrintable(ended.said));
    QVERIFY2(ended.said.contains("(--transport Normals)"), qPrintable(ended.said));
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
    QTRY_VERIFY_WITH_TIMEOUT((rank = rankOne(process.processId())) != 0, 20000);
    QTRY_COMPARE_WITH_TIMEOUT(noteOfRankOne(), QByteArray("3\n"), 20000);
    QCOMPARE(QProcess::execute("kill", {"-KILL", QString::number(rank)}), 0);
    QVERIFY(process.waitForFinished(patience));
    QVERIFY(process.exitCode() != 0);
    const QByteArray said = process.readAll();
    QVERIFY2(said.contains("run.pvtu: rank 1 ended while it worked on piece 4 of 6 ("), said);
    QVERIFY(test::namesIn(folder_ / "out").empty());
  }

  void wrongUsageIsStatusTwo() {
    QCOMPARE(run(2, {"--no-such-option"}).status, 2);
    QCOMPARE(run(1, {"--help"}).status, 0);
  }

 private:
  QString path(const char* name) const { return QString::fromStdString((folder_ / name).string()); }

  /// The process of rank 1, which `parent` started; 0 for none.
  static qint64 rankOne(qint64 parent) {
    for (const QByteArray& child : contentOf(QString("/proc/%1/task/%1/children").arg(parent)).split(' ')) {
      const QByteArray environment = contentOf(QString("/proc/%1/environ").arg(QString(child)));
      if (environment.split('\0').contains("OMPI_COMM_WORLD_RANK=1")) {
        return child.toLongLong();
      }
    }
    return 0;
  }

  /// What rank 1 has noted as its present work, in the folder of the staged files.
  QByteArray noteOfRankOne() const {
    const QStringList staged = QDir(path("out")).entryList(QDir::Dirs | QDir::Hidden | QDir::NoDotAndDotDot);
    return staged.isEmpty() ? QByteArray() : contentOf(path("out/") + staged.front() + "/r1.piece");
  }

  static QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

  std::unique_ptr<QTemporaryDir> dir_;
  std::filesystem::path folder_;
};

const test::Registration<ApplyMpiTest> registration;

}  // namespace pbffd

#include "apply_mpi_test.moc"
