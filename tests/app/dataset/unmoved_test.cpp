#include "app/dataset/apply.h"
#include "core/base/file.h"
#include "tests/app/dataset/fixture.h"
#include "tests/app/dataset/partition_fixture.h"
#include "tests/support/test_main.h"

#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <QTemporaryDir>
#include <QtTest>

Q_DECLARE_METATYPE(pbffd::test::XmlMode)

namespace pbffd {

/// What no point moved of keeps its very bytes, however it is written.
class UnmovedTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    dir_ = std::make_unique<QTemporaryDir>();
    folder_ = dir_->path().toStdString();
  }

  void unmovedFileKeepsEveryByte_data() {
    using test::XmlMode;
    QTest::addColumn<XmlMode>("mode");
    QTest::addColumn<bool>("isFar");
    for (const bool isFar : {false, true}) {
      const auto row = [&](const char* name, XmlMode mode) {
        QTest::addRow("%s, %s", name, isFar ? "far from what moves" : "at rest") << mode << isFar;
      };
      row("raw", XmlMode::raw);
      row("raw, other byte order", XmlMode::rawBigEndian);
      row("compressed", XmlMode::rawCompressed);
      row("base64", XmlMode::base64);
      row("text", XmlMode::ascii);
      row("inline", XmlMode::binary);
    }
  }
  void unmovedFileKeepsEveryByte() {
    QFETCH(test::XmlMode, mode);
    QFETCH(bool, isFar);
    const auto grid = placed(isFar);
    test::writeXml(folder_ / "a.vtu", *grid, mode);
    const ApplyReport report = applyToFile(project(isFar), folder_ / "a.vtu", folder_ / "b.vtu");
    QVERIFY(!report.hasMoved);
    QVERIFY(readFile(folder_ / "a.vtu") == readFile(folder_ / "b.vtu"));
  }

  void unmovedLegacyFileStaysText_data() {
    QTest::addColumn<bool>("isFar");
    QTest::newRow("at rest") << false;
    QTest::newRow("far from what moves") << true;
  }
  void unmovedLegacyFileStaysText() {
    QFETCH(bool, isFar);
    test::writeLegacy(folder_ / "a.vtk", *placed(isFar), false, 51);
    const ApplyReport report = applyToFile(project(isFar), folder_ / "a.vtk", folder_ / "b.vtk");
    QVERIFY(readFile(folder_ / "a.vtk") == readFile(folder_ / "b.vtk"));
    QCOMPARE(report.remarks.size(), std::size_t{1});
  }

  void unmovedPiecesKeepEveryByte() {
    test::writePartition(folder_ / "in/run.pvtu", 2);
    std::filesystem::create_directory(folder_ / "out");
    applyToFile(test::restingProject(), folder_ / "in/run.pvtu", folder_ / "out/run.pvtu");
    for (const char* name : {"run.pvtu", "run/0.vtu", "run/1.vtu"}) {
      QVERIFY(readFile(folder_ / "in" / name) == readFile(folder_ / "out" / name));
    }
  }

  void unmovedFileIsStillSearchedForItsArrays() {
    test::writeXml(folder_ / "a.vtu", *test::hexahedra(3, true), test::XmlMode::binary);
    const std::string message = test::messageOf([&] {
      applyToFile(test::restingProject(), folder_ / "a.vtu", folder_ / "b.vtu",
                  {false, parseTransports({"vorticity"}), {}});
    });
    QVERIFY2(QString::fromStdString(message).contains("'vorticity' of"), message.c_str());
  }

 private:
  static Project project(bool isFar) { return isFar ? test::bentProject() : test::restingProject(); }

  static vtkSmartPointer<vtkUnstructuredGrid> placed(bool isFar) {
    const auto grid = test::hexahedra(4, true);
    for (vtkIdType i = 0; isFar && i < grid->GetNumberOfPoints(); ++i) {
      double point[3];
      grid->GetPoint(i, point);
      point[0] += 50.0;
      grid->GetPoints()->SetPoint(i, point);
    }
    return grid;
  }

  std::unique_ptr<QTemporaryDir> dir_;
  std::filesystem::path folder_;
};

const test::Registration<UnmovedTest> registration;

}  // namespace pbffd

#include "unmoved_test.moc"
