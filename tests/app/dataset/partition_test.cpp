#include "app/dataset/partition.h"
#include "app/dataset/apply.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/ffd/deform/space_deformation.h"
#include "tests/app/dataset/fixture.h"
#include "tests/app/dataset/partition_fixture.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QtTest>

namespace pbffd {

class PartitionTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    dir_ = std::make_unique<QTemporaryDir>();
    folder_ = dir_->path().toStdString();
    std::filesystem::create_directories(folder_ / "in");
    std::filesystem::create_directories(folder_ / "out");
  }

  void piecesKeepTheirNamesUnderTheSameName() {
    test::writePartition(folder_ / "in/run.pvtu", 3);
    applyToFile(test::bentProject(), folder_ / "in/run.pvtu", folder_ / "out/run.pvtu");
    QCOMPARE(readFile(folder_ / "out/run.pvtu"), readFile(folder_ / "in/run.pvtu"));
    QCOMPARE(test::namesIn(folder_ / "out"), (std::vector<std::string>{"run", "run.pvtu"}));
    QCOMPARE(test::namesIn(folder_ / "out/run"), test::namesIn(folder_ / "in/run"));
  }

  void secondOutputLeavesThePiecesOfTheFirst() {
    test::writePartition(folder_ / "in/run.pvtu", 3);
    applyToFile(test::bentProject(), folder_ / "in/run.pvtu", folder_ / "out/a.pvtu");
    const auto firstPiece = [&] { return readFile(folder_ / "out/a/run/0.vtu"); };
    const std::string before = firstPiece();
    applyToFile(test::restingProject(), folder_ / "in/run.pvtu", folder_ / "out/b.pvtu");
    QVERIFY(firstPiece() == before);
    QVERIFY(readFile(folder_ / "out/b/run/0.vtu") != before);
    QVERIFY(QByteArray::fromStdString(readFile(folder_ / "out/b.pvtu")).contains("Source=\"b/run/0.vtu\""));
  }

  void piecesGoToAFolderOfTheirOwnBesideTheSource() {
    test::writePartition(folder_ / "in/run.pvtu", 3);
    applyToFile(test::bentProject(), folder_ / "in/run.pvtu", folder_ / "in/bent.pvtu");
    QVERIFY(
        QByteArray::fromStdString(readFile(folder_ / "in/bent.pvtu")).contains("Source=\"bent/run/0.vtu\""));
    QCOMPARE(test::namesIn(folder_ / "in/bent/run").size(), std::size_t{3});
  }

  void indexCanBeDeformedInPlace() {
    test::writePartition(folder_ / "in/run.pvtu", 2);
    const Points before = test::pointsOf(*test::readBack(folder_ / "in/run/1.vtu"));
    const Project project = test::bentProject();
    applyToFile(project, folder_ / "in/run.pvtu", folder_ / "in/run.pvtu");
    QVERIFY(test::pointsOf(*test::readBack(folder_ / "in/run/1.vtu")) ==
            SpaceDeformation(project.mesh, project.controls, ReachRule::all).positions(before));
  }

  void sharedPointsAgreeToTheLastBit() {
    test::writePartition(folder_ / "in/run.pvtu", 4);
    const ApplyReport report =
        applyToFile(test::bentProject(Reach::connected), folder_ / "in/run.pvtu", folder_ / "out/run.pvtu");
    QCOMPARE(report.pieces, std::size_t{4});
    for (int piece = 0; piece + 1 < 4; ++piece) {
      const auto points = [&](int number) {
        return test::pointsOf(*test::readBack(folder_ / format("out/run/{}.vtu", number)));
      };
      QVERIFY(points(piece).bottomRows(test::sharedPoints) == points(piece + 1).topRows(test::sharedPoints));
    }
  }

  void oneVolumeCellDecidesForAllPieces() {
    const Project project = test::bentProject(Reach::connected);
    test::writePartition(folder_ / "in/run.pvtu", 3);
    test::writeSurfacePiece(folder_ / "in/run/0.vtu");
    const Points rest = test::pointsOf(*test::readBack(folder_ / "in/run/0.vtu"));
    const ApplyReport report = applyToFile(project, folder_ / "in/run.pvtu", folder_ / "out/run.pvtu");
    QVERIFY(QString::fromStdString(report.remarks.at(0).text).contains("volume cells"));
    QVERIFY(test::pointsOf(*test::readBack(folder_ / "out/run/0.vtu")) ==
            SpaceDeformation(project.mesh, project.controls, ReachRule::all)
                .positions(rest)
                .cast<float>()
                .cast<double>());
  }

  void emptyPieceIsNoError() {
    test::writePartition(folder_ / "in/run.pvtu", 3);
    test::writeEmptyPiece(folder_ / "in/run/1.vtu");
    const ApplyReport report =
        applyToFile(test::bentProject(), folder_ / "in/run.pvtu", folder_ / "out/run.pvtu");
    QCOMPARE(report.pieces, std::size_t{3});
    QVERIFY(std::filesystem::exists(folder_ / "out/run/1.vtu"));
  }

  void emptyPieceNeedsNoArraysAndHasNothingToSay() {
    test::writePartition(folder_ / "in/run.pvtu", 3);
    test::writeEmptyPiece(folder_ / "in/run/0.vtu");
    ApplyOptions options;
    options.transports = {parseTransport("velocity")};
    const ApplyReport report =
        applyToFile(test::bentProject(), folder_ / "in/run.pvtu", folder_ / "out/run.pvtu", options);
    QVERIFY(test::pointArray(*test::readBack(folder_ / "out/run/1.vtu"), "velocity") !=
            test::pointArray(*test::readBack(folder_ / "in/run/1.vtu"), "velocity"));
    QCOMPARE(report.remarks.size(), std::size_t{1});
    QVERIFY(QString::fromStdString(report.remarks[0].option).contains("--transport Normals"));
  }

  void badInputNamesThePieceAndLeavesNothing_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("said");
    QTest::newRow("missing piece") << "missing"
                                   << "piece 2 of 3 (";
    QTest::newRow("damaged piece") << "damaged"
                                   << "piece 2 of 3 (";
    QTest::newRow("no points at all") << "empty"
                                      << "no points";
    QTest::newRow("no piece") << "none"
                              << "names no piece";
    QTest::newRow("no XML") << "words"
                            << "run.pvtu";
    QTest::newRow("one name twice") << "twice"
                                    << "like another piece";
    QTest::newRow("another ending") << "ending"
                                    << "run.vtu";
  }
  void badInputNamesThePieceAndLeavesNothing() {
    QFETCH(QString, kind);
    QFETCH(QString, said);
    test::writePartition(folder_ / "in/run.pvtu", 3);
    spoil(kind);
    const char* target = kind == "ending" ? "out/run.vtu" : "out/run.pvtu";
    const QString message = QString::fromStdString(
        test::messageOf([&] { applyToFile(test::bentProject(), folder_ / "in/run.pvtu", folder_ / target); }));
    QVERIFY2(message.contains(said), qPrintable(message));
    QVERIFY(test::namesIn(folder_ / "out").empty());
  }

  void pieceThatAnotherOneIsReadFromStays() {
    test::writePartition(folder_ / "in/run.pvtu", 3);
    // The new first piece would take the place of the second one's source, under whichever name.
    std::filesystem::create_directory(folder_ / "out/run");
    std::filesystem::create_hard_link(folder_ / "in/run/1.vtu", folder_ / "out/run/0.vtu");
    const std::string before = readFile(folder_ / "in/run/1.vtu");
    const QString message = QString::fromStdString(test::messageOf(
        [&] { applyToFile(test::bentProject(), folder_ / "in/run.pvtu", folder_ / "out/run.pvtu"); }));
    QVERIFY2(message.contains("out/run/0.vtu: it is piece 2 of 3 ("), qPrintable(message));
    QVERIFY(readFile(folder_ / "in/run/1.vtu") == before);
  }

  void nameThatIsNoPlainTextIsWrittenAsXml() {
    test::writePartition(folder_ / "in/run.pvtu", 2);
    std::filesystem::create_directory(folder_ / "in/a&b");
    std::filesystem::rename(folder_ / "in/run/0.vtu", folder_ / "in/a&b/0.vtu");
    std::string index = readFile(folder_ / "in/run.pvtu");
    index.replace(index.find("run/0.vtu"), 9, "a&amp;b/0.vtu");
    writeFileAtomically(folder_ / "in/run.pvtu", index);
    applyToFile(test::bentProject(), folder_ / "in/run.pvtu", folder_ / "out/run.pvtu");
    QCOMPARE(readFile(folder_ / "out/run.pvtu"), index);
    QVERIFY(std::filesystem::exists(folder_ / "out/a&b/0.vtu"));
  }

 private:
  void spoil(const QString& kind) const {
    const std::filesystem::path index = folder_ / "in/run.pvtu";
    std::string text = readFile(index);
    if (kind == "missing") {
      std::filesystem::remove(folder_ / "in/run/1.vtu");
    } else if (kind == "damaged") {
      const std::string bytes = readFile(folder_ / "in/run/1.vtu");
      writeFileAtomically(folder_ / "in/run/1.vtu", bytes.substr(0, bytes.size() / 2));
    } else if (kind == "empty") {
      for (const char* piece : {"0", "1", "2"}) {
        test::writeEmptyPiece(folder_ / "in/run" / (std::string(piece) + ".vtu"));
      }
    } else if (kind == "none") {
      writeFileAtomically(index, "<VTKFile type=\"PUnstructuredGrid\"><PUnstructuredGrid/></VTKFile>\n");
    } else if (kind == "words") {
      writeFileAtomically(index, "a < b, but these are only words\n");
    } else if (kind == "twice") {
      text.replace(text.find("run/1.vtu"), 9, "run/0.vtu");
      writeFileAtomically(index, text);
    }
  }

  std::unique_ptr<QTemporaryDir> dir_;
  std::filesystem::path folder_;
};

const test::Registration<PartitionTest> registration;

}  // namespace pbffd

#include "partition_test.moc"
